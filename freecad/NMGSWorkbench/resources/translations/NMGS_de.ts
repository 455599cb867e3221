<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Version of these properties</source>
        <translation>Version dieser Eigenschaften</translation>
    </message>
    <message>
        <source>Python class, for a FreeCAD that has found the workbench again</source>
        <translation>Python-Klasse, für ein FreeCAD, das die Arbeitsumgebung wiedergefunden hat</translation>
    </message>
    <message>
        <source>Faces or solids that the elements are fitted to; empty for elements given by their nodes</source>
        <translation>Flächen oder Körper, an die die Elemente angepasst sind; leer für Elemente, die durch ihre Knoten gegeben sind</translation>
    </message>
    <message>
        <source>File that the elements were read from</source>
        <translation>Datei, aus der die Elemente gelesen wurden</translation>
    </message>
    <message>
        <source>Shape of the library that the elements are; empty for others</source>
        <translation>Form der Bibliothek, die die Elemente bilden; leer für andere</translation>
    </message>
    <message>
        <source>Sizes and divisions of the library's shape, as JSON</source>
        <translation>Maße und Teilungen der Bibliotheksform, als JSON</translation>
    </message>
    <message>
        <source>Length of the mesh's elements that the divisions follow; 0 chooses one</source>
        <translation>Kantenlänge der Netzelemente, nach der sich die Teilungen richten; 0 wählt eine</translation>
    </message>
    <message>
        <source>Largest distance from the CAD surface that the fit accepts; 0 chooses one</source>
        <translation>Größter Abstand von der CAD-Fläche, den die Anpassung zulässt; 0 wählt einen</translation>
    </message>
    <message>
        <source>How solids are cut into blocks</source>
        <translation>Wie Körper in Blöcke zerlegt werden</translation>
    </message>
    <message>
        <source>Elements along edges of the part, a line each, as Edge3: 12 or Box.Edge3: 12</source>
        <translation>Elemente entlang von Kanten des Bauteils, eine Zeile je Kante, wie Edge3: 12 oder Box.Edge3: 12</translation>
    </message>
    <message>
        <source>Lay the last fit's blocks over the part again while only its dimensions change</source>
        <translation>Legt die Blöcke der letzten Anpassung wieder über das Bauteil, solange sich nur seine Maße ändern</translation>
    </message>
    <message>
        <source>Divisions follow Size; switch off to set Divisions by hand</source>
        <translation>Die Teilungen folgen Size; ausschalten, um Divisions von Hand zu setzen</translation>
    </message>
    <message>
        <source>Nodes of all elements, one element after the other, corners first</source>
        <translation>Knoten aller Elemente, ein Element nach dem anderen, Ecken zuerst</translation>
    </message>
    <message>
        <source>Number of elements along xi, eta (, zeta), one element after the other</source>
        <translation>Anzahl der Elemente entlang xi, eta (, zeta), ein Element nach dem anderen</translation>
    </message>
    <message>
        <source>Spacing of each element's directions; empty where all are uniform</source>
        <translation>Abstufung der Richtungen jedes Elements; leer, wo alle gleichmäßig sind</translation>
    </message>
    <message>
        <source>The user's reference text</source>
        <translation>Bezeichnung des Benutzers</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Anzahl der Elemente</translation>
    </message>
    <message>
        <source>What the fit found out about each face or solid</source>
        <translation>Was die Anpassung über jede Fläche oder jeden Körper herausgefunden hat</translation>
    </message>
    <message>
        <source>The fit's report as JSON, one line a face or solid</source>
        <translation>Bericht der Anpassung als JSON, eine Zeile je Fläche oder Körper</translation>
    </message>
    <message>
        <source>Solids that are cut</source>
        <translation>Volumenkörper, die zerschnitten werden</translation>
    </message>
    <message>
        <source>Faces and planes that cut; planes and round faces go through the whole solid</source>
        <translation>Flächen und Ebenen, die schneiden; ebene und runde Flächen gehen durch den ganzen Körper</translation>
    </message>
    <message>
        <source>Planes and cylinders that cut, one a line, as JSON</source>
        <translation>Ebenen und Zylinder, die schneiden, je Zeile einer, als JSON</translation>
    </message>
    <message>
        <source>Number of pieces</source>
        <translation>Anzahl der Stücke</translation>
    </message>
    <message>
        <source>File that the mesh was read from</source>
        <translation>Datei, aus der das Netz gelesen wurde</translation>
    </message>
    <message>
        <source>The blocks or patches that the file says the mesh was made of</source>
        <translation>Die Blöcke oder Flächenstücke, aus denen das Netz laut Datei gemacht wurde</translation>
    </message>
    <message>
        <source>Number of nodes</source>
        <translation>Anzahl der Knoten</translation>
    </message>
    <message>
        <source>Number of elements, those of the boundary not counted</source>
        <translation>Anzahl der Elemente, die des Randes nicht gezählt</translation>
    </message>
    <message>
        <source>Number of elements of each type</source>
        <translation>Anzahl der Elemente jeder Art</translation>
    </message>
    <message>
        <source>Smallest scaled Jacobian of all elements: 1 is ideal, 0 or less unusable</source>
        <translation>Kleinste skalierte Jacobi-Determinante aller Elemente: 1 ist ideal, 0 oder weniger unbrauchbar</translation>
    </message>
    <message>
        <source>The mesh while FemMesh is empty: it is large, and FEM has not asked for it yet</source>
        <translation>Das Netz, solange FemMesh leer ist: es ist groß, und FEM hat noch nicht danach gefragt</translation>
    </message>
    <message>
        <source>Hash of the mesh</source>
        <translation>Prüfsumme des Netzes</translation>
    </message>
    <message>
        <source>File that it was read from</source>
        <translation>Datei, aus der gelesen wurde</translation>
    </message>
    <message>
        <source>The complex as a .poly file</source>
        <translation>Der Komplex als .poly-Datei</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>Number of facets</source>
        <translation>Anzahl der Facetten</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>Anzahl der Löcher</translation>
    </message>
    <message>
        <source>Number of regions</source>
        <translation>Anzahl der Gebiete</translation>
    </message>
    <message>
        <source>Blocks or Patches to divide</source>
        <translation>Blöcke oder Flächenstücke, die geteilt werden</translation>
    </message>
    <message>
        <source>1 for linear elements, 2 for quadratic ones</source>
        <translation>1 für lineare Elemente, 2 für quadratische</translation>
    </message>
    <message>
        <source>Quads into 2 triangles, hexahedra into 12 tetrahedra</source>
        <translation>Vierecke in 2 Dreiecke, Hexaeder in 12 Tetraeder</translation>
    </message>
    <message>
        <source>Put the nodes onto the CAD surface</source>
        <translation>Die Knoten auf die CAD-Fläche legen</translation>
    </message>
    <message>
        <source>Nodes of different blocks closer than this are one; 0 chooses it</source>
        <translation>Knoten verschiedener Blöcke, die näher beieinander liegen, sind einer; 0 wählt den Abstand</translation>
    </message>
    <message>
        <source>Solid, PLC, blocks, patches or mesh whose volume is filled</source>
        <translation>Körper, PLC, Blöcke, Flächenstücke oder Netz, deren Volumen gefüllt wird</translation>
    </message>
    <message>
        <source>TetGen's switches</source>
        <translation>Schalter von TetGen</translation>
    </message>
    <message>
        <source>Seconds after which TetGen is stopped; 0 for no limit</source>
        <translation>Sekunden, nach denen TetGen angehalten wird; 0 für keine Grenze</translation>
    </message>
    <message>
        <source>Show the number of elements along each edge</source>
        <translation>Anzahl der Elemente an jeder Kante anzeigen</translation>
    </message>
    <message>
        <source>Elements as they are, or split into triangles or tetrahedra</source>
        <translation>Elemente wie sie sind, oder in Dreiecke oder Tetraeder geteilt</translation>
    </message>
    <message>
        <source>Show the faces across ξ of the blocks</source>
        <translation>Die Flächen quer zu ξ der Blöcke zeigen</translation>
    </message>
    <message>
        <source>Show the faces across η of the blocks</source>
        <translation>Die Flächen quer zu η der Blöcke zeigen</translation>
    </message>
    <message>
        <source>Show the faces across ζ of the blocks</source>
        <translation>Die Flächen quer zu ζ der Blöcke zeigen</translation>
    </message>
    <message>
        <source>Colour the elements by a metric of their quality</source>
        <translation>Die Elemente nach einem Maß ihrer Güte färben</translation>
    </message>
    <message>
        <source>Axis across which the mesh is cut open</source>
        <translation>Achse, quer zu der das Netz aufgeschnitten wird</translation>
    </message>
    <message>
        <source>Where the cut is, in percent of the mesh's length along the axis</source>
        <translation>Wo der Schnitt liegt, in Prozent der Länge des Netzes entlang der Achse</translation>
    </message>
    <message>
        <source>Keep the other side of the cut</source>
        <translation>Die andere Seite des Schnitts behalten</translation>
    </message>
    <message>
        <source>How much each element is drawn smaller, from 0 to 0.9</source>
        <translation>Um wie viel jedes Element kleiner gezeichnet wird, von 0 bis 0,9</translation>
    </message>
</context>
<context>
    <name>NMGS</name>
    <message>
        <source>CalculiX</source>
        <translation>CalculiX rechnet</translation>
    </message>
    <message>
        <source>Hemisphere</source>
        <translation>Halbkugelfläche</translation>
    </message>
    <message>
        <source>The thesis's own example: patches of 8 nodes become quads. Change the sizes or the divisions, and the mesh follows.</source>
        <translation>Das Beispiel der Dissertation selbst: Flächenstücke mit 8 Knoten werden zu Vierecken. Ändern Sie die Maße oder die Teilungen, und das Netz folgt.</translation>
    </message>
    <message>
        <source>O-grid flange</source>
        <translation>Flansch mit O-Gitter</translation>
    </message>
    <message>
        <source>A core of blocks with rings round it, none of them collapsed, so that all hexahedra are good. The blocks are given by their nodes.</source>
        <translation>Ein Kern aus Blöcken mit Ringen darum, keiner davon entartet, so dass alle Hexaeder gut sind. Die Blöcke sind durch ihre Knoten gegeben.</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Rohrbogen</translation>
    </message>
    <message>
        <source>A round bar with an O-grid, bent by 90 degrees, with elements that grow from both ends.</source>
        <translation>Ein Rundstab mit O-Gitter, um 90 Grad gebogen, mit Elementen, die von beiden Enden her wachsen.</translation>
    </message>
    <message>
        <source>Bracket with TetGen</source>
        <translation>Winkel mit TetGen</translation>
    </message>
    <message>
        <source>A part that has no obvious blocks: TetGen fills it with tetrahedra of good quality.</source>
        <translation>Ein Teil ohne naheliegende Blöcke: TetGen füllt es mit Tetraedern guter Güte.</translation>
    </message>
    <message>
        <source>FEM cantilever</source>
        <translation>FEM-Kragbalken</translation>
    </message>
    <message>
        <source>A bar as quadratic hexahedra in an analysis with a support and a load, to be solved.</source>
        <translation>Ein Stab als quadratische Hexaeder in einer Analyse mit Lager und Last, zum Lösen bereit.</translation>
    </message>
    <message>
        <source>Making the FEM mesh</source>
        <translation>Das FEM-Netz wird gemacht</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Anpassung läuft</translation>
    </message>
    <message>
        <source>Fitting blocks</source>
        <translation>Blöcke werden angepasst</translation>
    </message>
    <message>
        <source>Cutting solids</source>
        <translation>Körper werden zerschnitten</translation>
    </message>
    <message>
        <source>Handing the mesh over</source>
        <translation>Das Netz wird übergeben</translation>
    </message>
    <message>
        <source>Handing the mesh to FEM</source>
        <translation>Das Netz wird an FEM übergeben</translation>
    </message>
    <message>
        <source>Fitting patches</source>
        <translation>Flächenstücke werden angepasst</translation>
    </message>
    <message>
        <source>Generating the mesh</source>
        <translation>Das Netz wird erzeugt</translation>
    </message>
    <message>
        <source>TetGen is at work</source>
        <translation>TetGen arbeitet</translation>
    </message>
    <message>
        <source>Structured hexahedral meshes from blocks, TetGen meshes, and their way into FEM. LGPL-2.1-or-later; the program nmgs-tet alone, which links TetGen, is AGPL-3.0-or-later.</source>
        <translation>Strukturierte Hexaedernetze aus Blöcken, TetGen-Netze und ihr Weg in die FEM. LGPL-2.1-or-later; nur das Programm nmgs-tet, das TetGen einbindet, ist AGPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>About NMGS</source>
        <translation>Über NMGS</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stahl</translation>
    </message>
    <message>
        <source>Stainless steel</source>
        <translation>Edelstahl</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Titanium</source>
        <translation>Titan</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Kupfer</translation>
    </message>
    <message>
        <source>Cast iron</source>
        <translation>Gusseisen</translation>
    </message>
    <message>
        <source>Concrete</source>
        <translation>Beton</translation>
    </message>
    <message>
        <source>ABS</source>
        <translation>ABS</translation>
    </message>
    <message>
        <source>Along picked edge or face</source>
        <translation>Entlang ausgewählter Kante oder Fläche</translation>
    </message>
    <message>
        <source>Largest displacement {moved:.4g} mm, largest von Mises stress {stress:.4g} MPa</source>
        <translation>Größte Verschiebung {moved:.4g} mm, größte Vergleichsspannung nach von Mises {stress:.4g} MPa</translation>
    </message>
    <message>
        <source>Pick faces of the part in the view first.</source>
        <translation>Zuerst in der Ansicht Flächen des Teils auswählen.</translation>
    </message>
    <message>
        <source>A face must be held and one be loaded.</source>
        <translation>Eine Fläche muss gehalten und eine belastet sein.</translation>
    </message>
    <message>
        <source>{mesh} on {parts}</source>
        <translation>{mesh} auf {parts}</translation>
    </message>
    <message>
        <source>Along {name}</source>
        <translation>Entlang {name}</translation>
    </message>
    <message>
        <source>{mesh} is not on a part: there are no faces to hold or load.</source>
        <translation>{mesh} liegt auf keinem Teil: Es gibt keine Flächen zum Halten oder Belasten.</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Off the CAD</source>
        <translation>Abstand vom CAD</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>{blocks} blocks</source>
        <translation>{blocks} Blöcke</translation>
    </message>
    <message>
        <source>A click on a row picks what stands in the way of structured blocks.</source>
        <translation>Ein Klick auf eine Zeile wählt aus, was strukturierten Blöcken im Weg steht.</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>{left} of {all} could not be used</source>
        <translation>{left} von {all} konnten nicht verwendet werden</translation>
    </message>
    <message>
        <source>Divisions of element {element} along {axis}: expected a whole number, got {text!r}</source>
        <translation>Teilungen von Element {element} entlang {axis}: ganze Zahl erwartet, {text!r} erhalten</translation>
    </message>
    <message>
        <source>Cut solids</source>
        <translation>Körper zerschneiden</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>{count} pieces.</source>
        <translation>{count} Stücke.</translation>
    </message>
    <message>
        <source>Nothing stands in the way of blocks.</source>
        <translation>Blöcken steht nichts im Weg.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Resolves</source>
        <translation>Behebt</translation>
    </message>
    <message>
        <source>Pick faces or planes in the view first.</source>
        <translation>Zuerst in der Ansicht Flächen oder Ebenen auswählen.</translation>
    </message>
    <message>
        <source>Check a cut, or pick faces and add them.</source>
        <translation>Einen Schnitt ankreuzen, oder Flächen auswählen und hinzufügen.</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Abstufung</translation>
    </message>
    <message>
        <source>{direction} of block {block}: {count} directions of blocks change together.</source>
        <translation>{direction} von Block {block}: {count} Richtungen von Blöcken ändern sich gemeinsam.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Export {name}</source>
        <translation>{name} exportieren</translation>
    </message>
    <message>
        <source>Writing {path}</source>
        <translation>{path} wird geschrieben</translation>
    </message>
    <message>
        <source>No mesh yet</source>
        <translation>Noch kein Netz</translation>
    </message>
    <message>
        <source>{nodes} nodes; {elements}; worst scaled Jacobian {worst}</source>
        <translation>{nodes} Knoten; {elements}; kleinste skalierte Jacobi-Determinante {worst}</translation>
    </message>
    <message>
        <source>NMGS user guide</source>
        <translation>NMGS-Benutzerhandbuch</translation>
    </message>
    <message>
        <source>Edit {name}</source>
        <translation>{name} bearbeiten</translation>
    </message>
    <message>
        <source>Blocks by nodes</source>
        <translation>Blöcke durch Knoten</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>Zahl erwartet</translation>
    </message>
    <message>
        <source>expected a whole number from 1 on</source>
        <translation>ganze Zahl ab 1 erwartet</translation>
    </message>
    <message>
        <source>node {node}, {axis}</source>
        <translation>Knoten {node}, {axis}</translation>
    </message>
    <message>
        <source>The last block cannot be removed.</source>
        <translation>Der letzte Block kann nicht entfernt werden.</translation>
    </message>
    <message>
        <source>divisions along {axis}</source>
        <translation>Teilungen entlang {axis}</translation>
    </message>
    <message>
        <source>Block {block}, {what}: expected a number, got {text!r}</source>
        <translation>Block {block}, {what}: Zahl erwartet, {text!r} erhalten</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Option</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>The file's ending is to be one of {known}</source>
        <translation>Die Endung der Datei muss eine von {known} sein</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>Plot of {name}</source>
        <translation>Darstellung von {name}</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Wird angehalten</translation>
    </message>
    <message>
        <source>Measuring the mesh</source>
        <translation>Das Netz wird gemessen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Maß</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Schlechtester</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>Bester</translation>
    </message>
    <message>
        <source>Worst elements</source>
        <translation>Schlechteste Elemente</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>{count} elements from {low} to {high} are marked</source>
        <translation>{count} Elemente von {low} bis {high} sind markiert</translation>
    </message>
    <message>
        <source>Element {number} is marked</source>
        <translation>Element {number} ist markiert</translation>
    </message>
    <message>
        <source>Report of {name}</source>
        <translation>Bericht über {name}</translation>
    </message>
    <message>
        <source>{type} by {metric}; a click on a bar marks its elements</source>
        <translation>{type} nach {metric}; ein Klick auf einen Balken markiert seine Elemente</translation>
    </message>
    <message>
        <source>{axis}: {low} to {high} mm</source>
        <translation>{axis}: {low} bis {high} mm</translation>
    </message>
    <message>
        <source>Shape library</source>
        <translation>Formenbibliothek</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Kreisscheibe</translation>
    </message>
    <message>
        <source>Cylinder surface</source>
        <translation>Zylinderfläche</translation>
    </message>
    <message>
        <source>Cone surface</source>
        <translation>Kegelfläche</translation>
    </message>
    <message>
        <source>Sphere surface</source>
        <translation>Kugelfläche</translation>
    </message>
    <message>
        <source>Torus surface</source>
        <translation>Torusfläche</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Würfel</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Half ball</source>
        <translation>Halbkugel</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>Choose a shape.</source>
        <translation>Wählen Sie eine Form.</translation>
    </message>
    <message>
        <source>1: linear elements</source>
        <translation>1: lineare Elemente</translation>
    </message>
    <message>
        <source>2: quadratic elements</source>
        <translation>2: quadratische Elemente</translation>
    </message>
    <message>
        <source>Quality mesh of the boundary</source>
        <translation>Gutes Netz des Randes</translation>
    </message>
    <message>
        <source>Mesh of the boundary</source>
        <translation>Netz des Randes</translation>
    </message>
    <message>
        <source>Mesh of the boundary, its triangles kept</source>
        <translation>Netz des Randes, seine Dreiecke bleiben</translation>
    </message>
    <message>
        <source>Delaunay mesh of the points</source>
        <translation>Delaunay-Netz der Punkte</translation>
    </message>
    <message>
        <source>Convex hull of the points</source>
        <translation>Konvexe Hülle der Punkte</translation>
    </message>
    <message>
        <source>Own choice</source>
        <translation>Eigene Wahl</translation>
    </message>
</context>
<context>
    <name>NMGS_About</name>
    <message>
        <source>About NMGS</source>
        <translation>Über NMGS</translation>
    </message>
    <message>
        <source>Versions of the workbench and of everything that it is linked with</source>
        <translation>Versionen der Arbeitsumgebung und von allem, womit sie verbunden ist</translation>
    </message>
</context>
<context>
    <name>NMGS_Analysis</name>
    <message>
        <source>Static analysis</source>
        <translation>Statische Berechnung</translation>
    </message>
    <message>
        <source>Hold and load faces of the part that the picked mesh is on, and solve with CalculiX</source>
        <translation>Flächen des Teils, auf dem das ausgewählte Netz liegt, halten und belasten und mit CalculiX lösen</translation>
    </message>
</context>
<context>
    <name>NMGS_CutSolids</name>
    <message>
        <source>Cut solids</source>
        <translation>Körper zerschneiden</translation>
    </message>
    <message>
        <source>Cut picked solids into pieces that blocks fill: by the faces and planes picked with them, or where it is proposed</source>
        <translation>Zerschneidet ausgewählte Körper in Stücke, die Blöcke füllen: mit den dazu ausgewählten Flächen und Ebenen, oder wo es vorgeschlagen wird</translation>
    </message>
</context>
<context>
    <name>NMGS_Divisions</name>
    <message>
        <source>Divisions and grading</source>
        <translation>Teilungen und Abstufung</translation>
    </message>
    <message>
        <source>Number and spacing of the elements along picked edges of blocks, and along their chains</source>
        <translation>Anzahl und Abstände der Elemente entlang gewählter Kanten von Blöcken und ihrer Ketten</translation>
    </message>
</context>
<context>
    <name>NMGS_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Ready documents to start from: each shows one way from geometry to a mesh</source>
        <translation>Fertige Dokumente für den Anfang: jedes zeigt einen Weg von der Geometrie zum Netz</translation>
    </message>
</context>
<context>
    <name>NMGS_Export</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the picked blocks or mesh to a file: N2S, N3S, N2R, N3R, TetGen, FEM formats</source>
        <translation>Die gewählten Blöcke oder das Netz in eine Datei schreiben: N2S, N3S, N2R, N3R, TetGen, FEM-Formate</translation>
    </message>
</context>
<context>
    <name>NMGS_FitBlocks</name>
    <message>
        <source>Fit blocks to solids</source>
        <translation>Blöcke an Körper anpassen</translation>
    </message>
    <message>
        <source>Fill the picked solids, or the solids that own the picked faces, with 20-node blocks</source>
        <translation>Die gewählten Körper, oder die Körper der gewählten Flächen, mit Blöcken mit 20 Knoten füllen</translation>
    </message>
</context>
<context>
    <name>NMGS_FitPatches</name>
    <message>
        <source>Fit patches to faces</source>
        <translation>Flächenstücke an Flächen anpassen</translation>
    </message>
    <message>
        <source>Lay 8-node patches over the picked faces, or over all faces of the picked objects</source>
        <translation>Flächenstücke mit 8 Knoten auf die gewählten Flächen oder alle Flächen der gewählten Objekte legen</translation>
    </message>
</context>
<context>
    <name>NMGS_GenerateMesh</name>
    <message>
        <source>Generate mesh</source>
        <translation>Netz erzeugen</translation>
    </message>
    <message>
        <source>Divide the picked patches into quads, the picked blocks into hexahedra, as a FEM mesh</source>
        <translation>Die gewählten Flächenstücke in Vierecke, die gewählten Blöcke in Hexaeder teilen, als FEM-Netz</translation>
    </message>
</context>
<context>
    <name>NMGS_Help</name>
    <message>
        <source>NMGS user guide</source>
        <translation>NMGS-Benutzerhandbuch</translation>
    </message>
    <message>
        <source>The user guide: from a part to a mesh, every panel, file formats, the console</source>
        <translation>Das Benutzerhandbuch: vom Teil zum Netz, alle Aufgabenfenster, Dateiformate, die Konsole</translation>
    </message>
</context>
<context>
    <name>NMGS_MeshReport</name>
    <message>
        <source>Mesh report</source>
        <translation>Netzbericht</translation>
    </message>
    <message>
        <source>Counts, bounds, volume and quality of the picked mesh, with its worst elements</source>
        <translation>Anzahlen, Grenzen, Volumen und Güte des gewählten Netzes, mit seinen schlechtesten Elementen</translation>
    </message>
</context>
<context>
    <name>NMGS_NodeTable</name>
    <message>
        <source>Blocks by nodes</source>
        <translation>Blöcke durch Knoten</translation>
    </message>
    <message>
        <source>Type in patches of 8 nodes or blocks of 20 nodes, with a preview of their curved edges</source>
        <translation>Flächenstücke mit 8 Knoten oder Blöcke mit 20 Knoten eintippen, mit Vorschau ihrer krummen Kanten</translation>
    </message>
</context>
<context>
    <name>NMGS_Picture</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>The 3D view as PNG, PDF, SVG or on paper, with a title and axes</source>
        <translation>Die 3D-Ansicht als PNG, PDF, SVG oder auf Papier, mit Titel und Achsen</translation>
    </message>
</context>
<context>
    <name>NMGS_PlotOptions</name>
    <message>
        <source>Plot options</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>How the picked mesh is shown: split, by block directions, cut, shrunk, coloured by quality</source>
        <translation>Wie das gewählte Netz gezeigt wird: geteilt, nach Blockrichtungen, geschnitten, geschrumpft, nach Güte gefärbt</translation>
    </message>
</context>
<context>
    <name>NMGS_ShapeLibrary</name>
    <message>
        <source>Shape library</source>
        <translation>Formenbibliothek</translation>
    </message>
    <message>
        <source>Ready-made blocks and patches: cylinders, balls, tori and others, chosen by picture</source>
        <translation>Fertige Blöcke und Flächenstücke: Zylinder, Kugeln, Tori und andere, nach Bildern zu wählen</translation>
    </message>
</context>
<context>
    <name>NMGS_TetGenMesh</name>
    <message>
        <source>TetGen mesh</source>
        <translation>TetGen-Netz</translation>
    </message>
    <message>
        <source>Fill the picked solids, PLC, blocks or closed surface mesh with TetGen's tetrahedra</source>
        <translation>Die gewählten Körper, PLC, Blöcke oder das geschlossene Flächennetz mit TetGens Tetraedern füllen</translation>
    </message>
</context>
<context>
    <name>NMGS_Update</name>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Compute again the blocks and meshes whose geometry or divisions have changed</source>
        <translation>Die Blöcke und Netze neu berechnen, deren Geometrie oder Teilungen sich geändert haben</translation>
    </message>
</context>
<context>
    <name>analysis</name>
    <message>
        <source>Static analysis</source>
        <translation>Statische Berechnung</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Fills in the figures below, which can be changed</source>
        <translation>Füllt die Werte darunter aus, die geändert werden können</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Stress by strain</source>
        <translation>Spannung durch Dehnung</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Querdehnzahl</translation>
    </message>
    <message>
        <source>Strain across by strain along</source>
        <translation>Querdehnung durch Längsdehnung</translation>
    </message>
    <message>
        <source>Faces that are held</source>
        <translation>Flächen, die gehalten werden</translation>
    </message>
    <message>
        <source>None of their nodes can move; a double click takes a face away</source>
        <translation>Keiner ihrer Knoten kann sich bewegen; ein Doppelklick nimmt eine Fläche weg</translation>
    </message>
    <message>
        <source>Hold picked faces</source>
        <translation>Ausgewählte Flächen halten</translation>
    </message>
    <message>
        <source>Adds the faces that are picked in the view</source>
        <translation>Fügt die in der Ansicht ausgewählten Flächen hinzu</translation>
    </message>
    <message>
        <source>Faces that are loaded</source>
        <translation>Flächen, die belastet werden</translation>
    </message>
    <message>
        <source>They share the load; a double click takes a face away</source>
        <translation>Sie teilen sich die Last; ein Doppelklick nimmt eine Fläche weg</translation>
    </message>
    <message>
        <source>Load picked faces</source>
        <translation>Ausgewählte Flächen belasten</translation>
    </message>
    <message>
        <source>A force that all loaded faces share, or a pressure on each</source>
        <translation>Eine Kraft, die sich alle belasteten Flächen teilen, oder ein Druck auf jede</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>All loaded faces together</source>
        <translation>Alle belasteten Flächen zusammen</translation>
    </message>
    <message>
        <source>Into the part</source>
        <translation>In das Teil hinein</translation>
    </message>
    <message>
        <source>The force goes along the straight edge, or the normal of the flat face, that is picked in the view; without any, into the loaded face</source>
        <translation>Die Kraft wirkt entlang der geraden Kante oder der Normalen der ebenen Fläche, die in der Ansicht ausgewählt ist; ohne eine in die belastete Fläche hinein</translation>
    </message>
    <message>
        <source>The other way round</source>
        <translation>Anders herum</translation>
    </message>
    <message>
        <source>Turns the load's direction</source>
        <translation>Kehrt die Richtung der Last um</translation>
    </message>
    <message>
        <source>Solve with CalculiX</source>
        <translation>Mit CalculiX lösen</translation>
    </message>
    <message>
        <source>Off: only the analysis is made, to go on with in the FEM workbench</source>
        <translation>Aus: Es wird nur die Analyse angelegt, mit der im Arbeitsbereich FEM weitergearbeitet wird</translation>
    </message>
</context>
<context>
    <name>blocking</name>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Element size</source>
        <translation>Elementgröße</translation>
    </message>
    <message>
        <source>Length of the mesh's elements that the divisions follow; 0 chooses one</source>
        <translation>Kantenlänge der Netzelemente, nach der sich die Teilungen richten; 0 wählt eine</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest distance from the CAD surface that the fit accepts; 0 chooses one</source>
        <translation>Größter Abstand von der CAD-Fläche, den die Anpassung zulässt; 0 wählt einen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How faces are covered and solids are cut; auto takes what gives the best elements</source>
        <translation>Wie Flächen bedeckt und Körper zerlegt werden; auto nimmt, was die besten Elemente ergibt</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <source>Your own text, written into the files</source>
        <translation>Ihr eigener Text, der in die Dateien geschrieben wird</translation>
    </message>
    <message>
        <source>A click selects the face or solid in the view</source>
        <translation>Ein Klick wählt die Fläche oder den Körper in der Ansicht</translation>
    </message>
    <message>
        <source>Cut the solids...</source>
        <translation>Körper zerschneiden ...</translation>
    </message>
    <message>
        <source>Takes these options, then proposes cuts into pieces that structured blocks fill</source>
        <translation>Übernimmt diese Einstellungen und schlägt dann Schnitte in Stücke vor, die strukturierte Blöcke füllen</translation>
    </message>
    <message>
        <source>Lays the same blocks over the part again while only its dimensions change</source>
        <translation>Legt dieselben Blöcke wieder über das Bauteil, solange sich nur seine Maße ändern</translation>
    </message>
    <message>
        <source>Keep the layout when dimensions change</source>
        <translation>Aufteilung bei geänderten Maßen behalten</translation>
    </message>
    <message>
        <source>Divisions follow the element size</source>
        <translation>Teilungen folgen der Elementgröße</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Anzahl der Elemente entlang jeder Richtung jedes Blocks</translation>
    </message>
</context>
<context>
    <name>cuts</name>
    <message>
        <source>Cut solids</source>
        <translation>Körper zerschneiden</translation>
    </message>
    <message>
        <source>Checked rows cut. Choose a row to see where. What is proposed goes through edges that stand in the way of blocks.</source>
        <translation>Angekreuzte Zeilen schneiden. Eine gewählte Zeile zeigt, wo. Die Vorschläge gehen durch Kanten, die Blöcken im Weg stehen.</translation>
    </message>
    <message>
        <source>Cuts, and how many of the edges and vertices in the way lie on each</source>
        <translation>Schnitte, und wie viele der Kanten und Eckpunkte im Weg auf jedem liegen</translation>
    </message>
    <message>
        <source>Add picked faces</source>
        <translation>Ausgewählte Flächen hinzufügen</translation>
    </message>
    <message>
        <source>Faces and planes that are picked in the view cut as well; planes and round faces go through the whole solid</source>
        <translation>In der Ansicht ausgewählte Flächen und Ebenen schneiden auch; ebene und runde Flächen gehen durch den ganzen Körper</translation>
    </message>
</context>
<context>
    <name>divisions</name>
    <message>
        <source>Divisions and grading</source>
        <translation>Teilungen und Abstufung</translation>
    </message>
    <message>
        <source>Pick an edge of the blocks, or a row of the table.</source>
        <translation>Wählen Sie eine Kante der Blöcke oder eine Zeile der Tabelle.</translation>
    </message>
    <message>
        <source>Chains of edges that must have one number of elements</source>
        <translation>Ketten von Kanten, die eine gemeinsame Anzahl von Elementen haben müssen</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Number of elements along every edge of the chain</source>
        <translation>Anzahl der Elemente entlang jeder Kante der Kette</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Abstufung</translation>
    </message>
    <message>
        <source>How the elements are spaced along the arrows</source>
        <translation>Wie die Elemente entlang der Pfeile verteilt sind</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Geometric, by ratio</source>
        <translation>Geometrisch, nach Verhältnis</translation>
    </message>
    <message>
        <source>Geometric, by first size</source>
        <translation>Geometrisch, nach erster Größe</translation>
    </message>
    <message>
        <source>Geometric, by last size</source>
        <translation>Geometrisch, nach letzter Größe</translation>
    </message>
    <message>
        <source>Both ends, by ratio</source>
        <translation>Beide Enden, nach Verhältnis</translation>
    </message>
    <message>
        <source>Both ends, by sizes</source>
        <translation>Beide Enden, nach Größen</translation>
    </message>
    <message>
        <source>Hyperbolic tangent</source>
        <translation>Tangens hyperbolicus</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>Each element is so many times as long as the one before</source>
        <translation>Jedes Element ist so viele Male so lang wie das davor</translation>
    </message>
    <message>
        <source>First size</source>
        <translation>Erste Größe</translation>
    </message>
    <message>
        <source>Length of the element at the arrow's tail</source>
        <translation>Länge des Elements am Anfang des Pfeils</translation>
    </message>
    <message>
        <source>Last size</source>
        <translation>Letzte Größe</translation>
    </message>
    <message>
        <source>Length of the element at the arrow's tip</source>
        <translation>Länge des Elements an der Spitze des Pfeils</translation>
    </message>
    <message>
        <source>Turn round</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Grade from the other end</source>
        <translation>Vom anderen Ende her abstufen</translation>
    </message>
</context>
<context>
    <name>export</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Formats that can hold what is picked</source>
        <translation>Formate, die das Gewählte aufnehmen können</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File to write; its ending follows the format</source>
        <translation>Zu schreibende Datei; ihre Endung folgt dem Format</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen...</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Elements with or without mid-side nodes</source>
        <translation>Elemente mit oder ohne Knoten auf den Seitenmitten</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Wie es ist</translation>
    </message>
    <message>
        <source>1: linear elements</source>
        <translation>1: lineare Elemente</translation>
    </message>
    <message>
        <source>2: quadratic elements</source>
        <translation>2: quadratische Elemente</translation>
    </message>
    <message>
        <source>Split into triangles or tetrahedra</source>
        <translation>In Dreiecke oder Tetraeder teilen</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Groups of nodes and elements to write</source>
        <translation>Gruppen von Knoten und Elementen, die geschrieben werden</translation>
    </message>
</context>
<context>
    <name>node_table</name>
    <message>
        <source>Blocks by nodes</source>
        <translation>Blöcke durch Knoten</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Patches of 8 nodes</source>
        <translation>Flächenstücke mit 8 Knoten</translation>
    </message>
    <message>
        <source>Blocks of 20 nodes</source>
        <translation>Blöcke mit 20 Knoten</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Bezeichnung</translation>
    </message>
    <message>
        <source>Your own text, written into the files</source>
        <translation>Ihr eigener Text, der in die Dateien geschrieben wird</translation>
    </message>
    <message>
        <source>Add a block</source>
        <translation>Block hinzufügen</translation>
    </message>
    <message>
        <source>Appends a block beside the last one</source>
        <translation>Hängt einen Block neben den letzten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the block of the row that is chosen</source>
        <translation>Entfernt den Block der gewählten Zeile</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>Puts the mid-side nodes of the chosen block into the middle of their edges</source>
        <translation>Legt die Seitenmittenknoten des gewählten Blocks in die Mitte ihrer Kanten</translation>
    </message>
    <message>
        <source>Coordinates of the nodes: corners first, then mid-side nodes, as the thesis numbers them</source>
        <translation>Koordinaten der Knoten: Ecken zuerst, dann Seitenmitten, wie die Dissertation sie nummeriert</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Anzahl der Elemente entlang jeder Richtung jedes Blocks</translation>
    </message>
</context>
<context>
    <name>picture</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>PNG, PDF or SVG by its ending</source>
        <translation>PNG, PDF oder SVG nach ihrer Endung</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Durchsuchen...</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Axes and their lengths</source>
        <translation>Achsen und ihre Längen</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>As in the view</source>
        <translation>Wie in der Ansicht</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Durchsichtig</translation>
    </message>
    <message>
        <source>Print...</source>
        <translation>Drucken...</translation>
    </message>
</context>
<context>
    <name>plot</name>
    <message>
        <source>Plot options</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Triangles or tetrahedra</source>
        <translation>Dreiecke oder Tetraeder</translation>
    </message>
    <message>
        <source>Faces across</source>
        <translation>Flächen quer zu</translation>
    </message>
    <message>
        <source>ξ</source>
        <translation>ξ</translation>
    </message>
    <message>
        <source>η</source>
        <translation>η</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>A metric of quality, with its legend</source>
        <translation>Ein Maß der Güte, mit seiner Legende</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Schnitt quer zu</translation>
    </message>
    <message>
        <source>Leaves out the elements on one side of a plane</source>
        <translation>Lässt die Elemente auf einer Seite einer Ebene weg</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Schnitt bei</translation>
    </message>
    <message>
        <source>Keep the other side</source>
        <translation>Die andere Seite behalten</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schrumpfen</translation>
    </message>
    <message>
        <source>Draws each element smaller, so that all are seen</source>
        <translation>Zeichnet jedes Element kleiner, so dass alle zu sehen sind</translation>
    </message>
    <message>
        <source>Number of elements on the edges of the blocks</source>
        <translation>Anzahl der Elemente an den Kanten der Blöcke</translation>
    </message>
</context>
<context>
    <name>preferences</name>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Recompute blocks and meshes at once</source>
        <translation>Blöcke und Netze sofort neu berechnen</translation>
    </message>
    <message>
        <source>Off: what depends on a change is marked as stale until it is updated</source>
        <translation>Aus: was von einer Änderung abhängt, wird als veraltet markiert, bis es aktualisiert wird</translation>
    </message>
    <message>
        <source>Show the number of elements on the edges of new blocks</source>
        <translation>Anzahl der Elemente an den Kanten neuer Blöcke zeigen</translation>
    </message>
    <message>
        <source>Quality below which a mesh is warned of</source>
        <translation>Güte, unter der vor einem Netz gewarnt wird</translation>
    </message>
    <message>
        <source>Worst scaled Jacobian</source>
        <translation>Kleinste skalierte Jacobi-Determinante</translation>
    </message>
    <message>
        <source>Elements that FreeCAD's own view is given at most</source>
        <translation>Elemente, die FreeCADs eigene Ansicht höchstens bekommt</translation>
    </message>
    <message>
        <source>Larger meshes are handed to FEM when an analysis takes them</source>
        <translation>Größere Netze werden an FEM übergeben, wenn eine Analyse sie aufnimmt</translation>
    </message>
    <message>
        <source>Time limit of TetGen, s</source>
        <translation>Zeitgrenze von TetGen, s</translation>
    </message>
    <message>
        <source>For new TetGen meshes; 0 for none</source>
        <translation>Für neue TetGen-Netze; 0 für keine</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>Mesh report</source>
        <translation>Netzbericht</translation>
    </message>
    <message>
        <source>Choose a metric to see how its values are spread</source>
        <translation>Wählen Sie ein Maß, um zu sehen, wie seine Werte verteilt sind</translation>
    </message>
    <message>
        <source>Elements by value; a click on a bar marks its elements in the view</source>
        <translation>Elemente nach Wert; ein Klick auf einen Balken markiert seine Elemente in der Ansicht</translation>
    </message>
    <message>
        <source>The worst elements; a click zooms to one</source>
        <translation>Die schlechtesten Elemente; ein Klick zoomt auf eines</translation>
    </message>
    <message>
        <source>Colour the mesh by this metric</source>
        <translation>Das Netz nach diesem Maß färben</translation>
    </message>
</context>
<context>
    <name>shape_library</name>
    <message>
        <source>Shape library</source>
        <translation>Formenbibliothek</translation>
    </message>
    <message>
        <source>Ready-made blocks; choose one</source>
        <translation>Fertige Blöcke; wählen Sie eine Form</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>Innenradius</translation>
    </message>
    <message>
        <source>Top radius</source>
        <translation>Oberer Radius</translation>
    </message>
    <message>
        <source>Tube radius</source>
        <translation>Rohrradius</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Teilungen</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Anzahl der Elemente entlang jeder Richtung jedes Blocks</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Blocks into which each block is cut; more of them follow round shapes better</source>
        <translation>Blöcke, in die jeder Block geschnitten wird; mehr davon folgen runden Formen besser</translation>
    </message>
    <message>
        <source>Caps</source>
        <translation>Deckel</translation>
    </message>
    <message>
        <source>With both ends</source>
        <translation>Mit beiden Enden</translation>
    </message>
</context>
<context>
    <name>structured_mesh</name>
    <message>
        <source>Structured mesh</source>
        <translation>Strukturiertes Netz</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Split into triangles or tetrahedra</source>
        <translation>In Dreiecke oder Tetraeder teilen</translation>
    </message>
    <message>
        <source>Put the nodes onto the CAD surface</source>
        <translation>Die Knoten auf die CAD-Fläche legen</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Nodes of different blocks closer than this are one; 0 chooses it</source>
        <translation>Knoten verschiedener Blöcke, die näher beieinander liegen, sind einer; 0 wählt den Abstand</translation>
    </message>
</context>
<context>
    <name>tetgen_mesh</name>
    <message>
        <source>TetGen mesh</source>
        <translation>TetGen-Netz</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Kinds of mesh to start from; what is set by hand below is replaced</source>
        <translation>Arten von Netzen für den Anfang; was unten von Hand gesetzt ist, wird ersetzt</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>TetGen's switches, for example pq1.2a5: p fill a boundary, q quality, a largest volume</source>
        <translation>Schalter von TetGen, zum Beispiel pq1.2a5: p einen Rand füllen, q Güte, a größtes Volumen</translation>
    </message>
    <message>
        <source>Every option of TetGen by name, with its letter; pointing at one tells what it does</source>
        <translation>Jede Option von TetGen mit Namen und Buchstaben; darauf zeigen sagt, was sie bewirkt</translation>
    </message>
    <message>
        <source>Time limit, s</source>
        <translation>Zeitgrenze, s</translation>
    </message>
    <message>
        <source>Seconds after which TetGen is stopped; 0 for no limit</source>
        <translation>Sekunden, nach denen TetGen angehalten wird; 0 für keine Grenze</translation>
    </message>
    <message>
        <source>TetGen's own words appear here after Apply.</source>
        <translation>TetGens eigene Worte erscheinen hier nach Anwenden.</translation>
    </message>
</context>
</TS>
