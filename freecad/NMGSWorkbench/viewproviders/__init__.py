# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers. Names of modules and classes are saved in documents and never change."""
