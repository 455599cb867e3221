# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: widgets only; OK is one undo step, Cancel leaves no trace."""
