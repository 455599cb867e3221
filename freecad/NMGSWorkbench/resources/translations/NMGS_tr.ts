<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->
<!DOCTYPE TS>
<TS version="2.1" language="tr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Version of these properties</source>
        <translation>Bu özelliklerin sürümü</translation>
    </message>
    <message>
        <source>Python class, for a FreeCAD that has found the workbench again</source>
        <translation>Çalışma tezgahını yeniden bulan bir FreeCAD için Python sınıfı</translation>
    </message>
    <message>
        <source>Faces or solids that the elements are fitted to; empty for elements given by their nodes</source>
        <translation>Elemanların oturtulduğu yüzler veya katılar; düğümleriyle verilen elemanlar için boş</translation>
    </message>
    <message>
        <source>File that the elements were read from</source>
        <translation>Elemanların okunduğu dosya</translation>
    </message>
    <message>
        <source>Shape of the library that the elements are; empty for others</source>
        <translation>Elemanların oluşturduğu kitaplık şekli; diğerleri için boş</translation>
    </message>
    <message>
        <source>Sizes and divisions of the library's shape, as JSON</source>
        <translation>Kitaplık şeklinin ölçüleri ve bölünmeleri, JSON olarak</translation>
    </message>
    <message>
        <source>Length of the mesh's elements that the divisions follow; 0 chooses one</source>
        <translation>Bölünmelerin uyduğu ağ elemanı uzunluğu; 0 kendisi seçer</translation>
    </message>
    <message>
        <source>Largest distance from the CAD surface that the fit accepts; 0 chooses one</source>
        <translation>Oturtmanın kabul ettiği, CAD yüzeyinden en büyük uzaklık; 0 kendisi seçer</translation>
    </message>
    <message>
        <source>How solids are cut into blocks</source>
        <translation>Katıların bloklara nasıl ayrıldığı</translation>
    </message>
    <message>
        <source>Elements along edges of the part, a line each, as Edge3: 12 or Box.Edge3: 12</source>
        <translation>Parçanın kenarları boyunca eleman sayıları, her satırda bir kenar: Edge3: 12 ya da Box.Edge3: 12</translation>
    </message>
    <message>
        <source>Lay the last fit's blocks over the part again while only its dimensions change</source>
        <translation>Yalnızca ölçüler değiştikçe son uydurmanın bloklarını parçaya yeniden oturtur</translation>
    </message>
    <message>
        <source>Divisions follow Size; switch off to set Divisions by hand</source>
        <translation>Bölünmeler Size değerine uyar; Divisions'ı elle ayarlamak için kapatın</translation>
    </message>
    <message>
        <source>Nodes of all elements, one element after the other, corners first</source>
        <translation>Bütün elemanların düğümleri, eleman eleman, önce köşeler</translation>
    </message>
    <message>
        <source>Number of elements along xi, eta (, zeta), one element after the other</source>
        <translation>xi, eta (, zeta) boyunca eleman sayısı, eleman eleman</translation>
    </message>
    <message>
        <source>Spacing of each element's directions; empty where all are uniform</source>
        <translation>Her elemanın yönlerindeki aralıklar; hepsi eşitse boş</translation>
    </message>
    <message>
        <source>The user's reference text</source>
        <translation>Kullanıcının açıklama metni</translation>
    </message>
    <message>
        <source>Number of elements</source>
        <translation>Eleman sayısı</translation>
    </message>
    <message>
        <source>What the fit found out about each face or solid</source>
        <translation>Oturtmanın her yüz veya katı hakkında buldukları</translation>
    </message>
    <message>
        <source>The fit's report as JSON, one line a face or solid</source>
        <translation>Oturtma raporu JSON olarak, her yüz veya katı için bir satır</translation>
    </message>
    <message>
        <source>Solids that are cut</source>
        <translation>Kesilen katılar</translation>
    </message>
    <message>
        <source>Faces and planes that cut; planes and round faces go through the whole solid</source>
        <translation>Kesen yüzeyler ve düzlemler; düz ve yuvarlak yüzeyler katının tamamından geçer</translation>
    </message>
    <message>
        <source>Planes and cylinders that cut, one a line, as JSON</source>
        <translation>Kesen düzlemler ve silindirler, her satırda bir tane, JSON olarak</translation>
    </message>
    <message>
        <source>Number of pieces</source>
        <translation>Parça sayısı</translation>
    </message>
    <message>
        <source>File that the mesh was read from</source>
        <translation>Ağın okunduğu dosya</translation>
    </message>
    <message>
        <source>The blocks or patches that the file says the mesh was made of</source>
        <translation>Dosyaya göre ağın yapıldığı bloklar veya yamalar</translation>
    </message>
    <message>
        <source>Number of nodes</source>
        <translation>Düğüm sayısı</translation>
    </message>
    <message>
        <source>Number of elements, those of the boundary not counted</source>
        <translation>Eleman sayısı, sınırdakiler sayılmadan</translation>
    </message>
    <message>
        <source>Number of elements of each type</source>
        <translation>Her türden eleman sayısı</translation>
    </message>
    <message>
        <source>Smallest scaled Jacobian of all elements: 1 is ideal, 0 or less unusable</source>
        <translation>Bütün elemanların en küçük ölçekli Jacobi değeri: 1 idealdir, 0 veya altı kullanılamaz</translation>
    </message>
    <message>
        <source>The mesh while FemMesh is empty: it is large, and FEM has not asked for it yet</source>
        <translation>FemMesh boşken ağ: büyüktür ve FEM henüz istememiştir</translation>
    </message>
    <message>
        <source>Hash of the mesh</source>
        <translation>Ağın özeti</translation>
    </message>
    <message>
        <source>File that it was read from</source>
        <translation>Okunduğu dosya</translation>
    </message>
    <message>
        <source>The complex as a .poly file</source>
        <translation>Kompleks, .poly dosyası olarak</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Nokta sayısı</translation>
    </message>
    <message>
        <source>Number of facets</source>
        <translation>Faset sayısı</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>Delik sayısı</translation>
    </message>
    <message>
        <source>Number of regions</source>
        <translation>Bölge sayısı</translation>
    </message>
    <message>
        <source>Blocks or Patches to divide</source>
        <translation>Bölünecek bloklar veya yamalar</translation>
    </message>
    <message>
        <source>1 for linear elements, 2 for quadratic ones</source>
        <translation>Doğrusal elemanlar için 1, karesel elemanlar için 2</translation>
    </message>
    <message>
        <source>Quads into 2 triangles, hexahedra into 12 tetrahedra</source>
        <translation>Dörtgenler 2 üçgene, altıyüzlüler 12 dörtyüzlüye</translation>
    </message>
    <message>
        <source>Put the nodes onto the CAD surface</source>
        <translation>Düğümleri CAD yüzeyine koy</translation>
    </message>
    <message>
        <source>Nodes of different blocks closer than this are one; 0 chooses it</source>
        <translation>Farklı blokların bundan yakın düğümleri birdir; 0 kendisi seçer</translation>
    </message>
    <message>
        <source>Solid, PLC, blocks, patches or mesh whose volume is filled</source>
        <translation>Hacmi doldurulan katı, PLC, bloklar, yamalar veya ağ</translation>
    </message>
    <message>
        <source>TetGen's switches</source>
        <translation>TetGen anahtarları</translation>
    </message>
    <message>
        <source>Seconds after which TetGen is stopped; 0 for no limit</source>
        <translation>TetGen'in durdurulacağı saniye; sınır yoksa 0</translation>
    </message>
    <message>
        <source>Show the number of elements along each edge</source>
        <translation>Her kenar boyunca eleman sayısını göster</translation>
    </message>
    <message>
        <source>Elements as they are, or split into triangles or tetrahedra</source>
        <translation>Elemanlar oldukları gibi veya üçgenlere ya da dörtyüzlülere bölünmüş</translation>
    </message>
    <message>
        <source>Show the faces across ξ of the blocks</source>
        <translation>Blokların ξ yönüne dik yüzlerini göster</translation>
    </message>
    <message>
        <source>Show the faces across η of the blocks</source>
        <translation>Blokların η yönüne dik yüzlerini göster</translation>
    </message>
    <message>
        <source>Show the faces across ζ of the blocks</source>
        <translation>Blokların ζ yönüne dik yüzlerini göster</translation>
    </message>
    <message>
        <source>Colour the elements by a metric of their quality</source>
        <translation>Elemanları bir kalite ölçüsüne göre renklendir</translation>
    </message>
    <message>
        <source>Axis across which the mesh is cut open</source>
        <translation>Ağın dik olarak kesildiği eksen</translation>
    </message>
    <message>
        <source>Where the cut is, in percent of the mesh's length along the axis</source>
        <translation>Kesitin yeri, ağın eksen boyunca uzunluğunun yüzdesi olarak</translation>
    </message>
    <message>
        <source>Keep the other side of the cut</source>
        <translation>Kesitin öbür yanını tut</translation>
    </message>
    <message>
        <source>How much each element is drawn smaller, from 0 to 0.9</source>
        <translation>Her elemanın ne kadar küçük çizileceği, 0 ile 0,9 arası</translation>
    </message>
</context>
<context>
    <name>NMGS</name>
    <message>
        <source>CalculiX</source>
        <translation>CalculiX çözüyor</translation>
    </message>
    <message>
        <source>Hemisphere</source>
        <translation>Yarım küre yüzeyi</translation>
    </message>
    <message>
        <source>The thesis's own example: patches of 8 nodes become quads. Change the sizes or the divisions, and the mesh follows.</source>
        <translation>Tezin kendi örneği: 8 düğümlü yamalar dörtgen olur. Ölçüleri veya bölünmeleri değiştirin, ağ uyar.</translation>
    </message>
    <message>
        <source>O-grid flange</source>
        <translation>O-ızgaralı flanş</translation>
    </message>
    <message>
        <source>A core of blocks with rings round it, none of them collapsed, so that all hexahedra are good. The blocks are given by their nodes.</source>
        <translation>Çevresinde halkalar olan, hiçbiri çökmemiş bloklardan bir çekirdek; böylece bütün altıyüzlüler iyidir. Bloklar düğümleriyle verilmiştir.</translation>
    </message>
    <message>
        <source>Elbow</source>
        <translation>Dirsek</translation>
    </message>
    <message>
        <source>A round bar with an O-grid, bent by 90 degrees, with elements that grow from both ends.</source>
        <translation>90 derece bükülmüş, O-ızgaralı yuvarlak çubuk; elemanlar iki uçtan içeriye büyür.</translation>
    </message>
    <message>
        <source>Bracket with TetGen</source>
        <translation>TetGen ile köşebent</translation>
    </message>
    <message>
        <source>A part that has no obvious blocks: TetGen fills it with tetrahedra of good quality.</source>
        <translation>Belirgin blokları olmayan bir parça: TetGen onu iyi kaliteli dörtyüzlülerle doldurur.</translation>
    </message>
    <message>
        <source>FEM cantilever</source>
        <translation>FEM konsol kirişi</translation>
    </message>
    <message>
        <source>A bar as quadratic hexahedra in an analysis with a support and a load, to be solved.</source>
        <translation>Mesnet ve yük içeren bir analizde karesel altıyüzlülerle bir çubuk, çözülmeye hazır.</translation>
    </message>
    <message>
        <source>Making the FEM mesh</source>
        <translation>FEM ağı hazırlanıyor</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Oturtuluyor</translation>
    </message>
    <message>
        <source>Fitting blocks</source>
        <translation>Bloklar oturtuluyor</translation>
    </message>
    <message>
        <source>Cutting solids</source>
        <translation>Katılar kesiliyor</translation>
    </message>
    <message>
        <source>Handing the mesh over</source>
        <translation>Ağ aktarılıyor</translation>
    </message>
    <message>
        <source>Handing the mesh to FEM</source>
        <translation>Ağ FEM'e aktarılıyor</translation>
    </message>
    <message>
        <source>Fitting patches</source>
        <translation>Yamalar oturtuluyor</translation>
    </message>
    <message>
        <source>Generating the mesh</source>
        <translation>Ağ oluşturuluyor</translation>
    </message>
    <message>
        <source>TetGen is at work</source>
        <translation>TetGen çalışıyor</translation>
    </message>
    <message>
        <source>Structured hexahedral meshes from blocks, TetGen meshes, and their way into FEM. LGPL-2.1-or-later; the program nmgs-tet alone, which links TetGen, is AGPL-3.0-or-later.</source>
        <translation>Bloklardan yapılı altıyüzlü ağlar, TetGen ağları ve bunların FEM'e yolu. LGPL-2.1-or-later; yalnız TetGen'i bağlayan nmgs-tet programı AGPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>About NMGS</source>
        <translation>NMGS hakkında</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Çelik</translation>
    </message>
    <message>
        <source>Stainless steel</source>
        <translation>Paslanmaz çelik</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Alüminyum</translation>
    </message>
    <message>
        <source>Titanium</source>
        <translation>Titanyum</translation>
    </message>
    <message>
        <source>Copper</source>
        <translation>Bakır</translation>
    </message>
    <message>
        <source>Cast iron</source>
        <translation>Dökme demir</translation>
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
        <translation>Seçilen kenar ya da yüzey boyunca</translation>
    </message>
    <message>
        <source>Largest displacement {moved:.4g} mm, largest von Mises stress {stress:.4g} MPa</source>
        <translation>En büyük yer değiştirme {moved:.4g} mm, en büyük von Mises gerilmesi {stress:.4g} MPa</translation>
    </message>
    <message>
        <source>Pick faces of the part in the view first.</source>
        <translation>Önce görünümde parçanın yüzeylerini seçin.</translation>
    </message>
    <message>
        <source>A face must be held and one be loaded.</source>
        <translation>Bir yüzey tutulmalı, bir yüzey yüklenmelidir.</translation>
    </message>
    <message>
        <source>{mesh} on {parts}</source>
        <translation>{parts} üzerinde {mesh}</translation>
    </message>
    <message>
        <source>Along {name}</source>
        <translation>{name} boyunca</translation>
    </message>
    <message>
        <source>{mesh} is not on a part: there are no faces to hold or load.</source>
        <translation>{mesh} bir parça üzerinde değil: tutulacak ya da yüklenecek yüzey yok.</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometri</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Yöntem</translation>
    </message>
    <message>
        <source>Off the CAD</source>
        <translation>CAD'den sapma</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Neden</translation>
    </message>
    <message>
        <source>{blocks} blocks</source>
        <translation>{blocks} blok</translation>
    </message>
    <message>
        <source>A click on a row picks what stands in the way of structured blocks.</source>
        <translation>Bir satıra tıklamak, yapılandırılmış blokların önündeki engelleri seçer.</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>dışarıda kaldı</translation>
    </message>
    <message>
        <source>{left} of {all} could not be used</source>
        <translation>{all} içinden {left} tanesi kullanılamadı</translation>
    </message>
    <message>
        <source>Divisions of element {element} along {axis}: expected a whole number, got {text!r}</source>
        <translation>{element}. elemanın {axis} boyunca bölünmeleri: tam sayı beklendi, {text!r} bulundu</translation>
    </message>
    <message>
        <source>Cut solids</source>
        <translation>Katıları kes</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>düzlem</translation>
    </message>
    <message>
        <source>{count} pieces.</source>
        <translation>{count} parça.</translation>
    </message>
    <message>
        <source>Nothing stands in the way of blocks.</source>
        <translation>Blokların önünde engel yok.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Kesim</translation>
    </message>
    <message>
        <source>Resolves</source>
        <translation>Giderir</translation>
    </message>
    <message>
        <source>Pick faces or planes in the view first.</source>
        <translation>Önce görünümde yüzey veya düzlem seçin.</translation>
    </message>
    <message>
        <source>Check a cut, or pick faces and add them.</source>
        <translation>Bir kesim işaretleyin ya da yüzey seçip ekleyin.</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>eşit</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Yön</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kenarlar</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemanlar</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Sıklaştırma</translation>
    </message>
    <message>
        <source>{direction} of block {block}: {count} directions of blocks change together.</source>
        <translation>{block}. bloğun {direction} yönü: blokların {count} yönü birlikte değişir.</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Örnekler</translation>
    </message>
    <message>
        <source>Export {name}</source>
        <translation>{name} dışa aktar</translation>
    </message>
    <message>
        <source>Writing {path}</source>
        <translation>{path} yazılıyor</translation>
    </message>
    <message>
        <source>No mesh yet</source>
        <translation>Henüz ağ yok</translation>
    </message>
    <message>
        <source>{nodes} nodes; {elements}; worst scaled Jacobian {worst}</source>
        <translation>{nodes} düğüm; {elements}; en kötü ölçekli Jacobi {worst}</translation>
    </message>
    <message>
        <source>NMGS user guide</source>
        <translation>NMGS kullanıcı kılavuzu</translation>
    </message>
    <message>
        <source>Edit {name}</source>
        <translation>{name} düzenle</translation>
    </message>
    <message>
        <source>Blocks by nodes</source>
        <translation>Düğümlerle bloklar</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Düğüm</translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation>sayı beklendi</translation>
    </message>
    <message>
        <source>expected a whole number from 1 on</source>
        <translation>1 veya daha büyük tam sayı beklendi</translation>
    </message>
    <message>
        <source>node {node}, {axis}</source>
        <translation>düğüm {node}, {axis}</translation>
    </message>
    <message>
        <source>The last block cannot be removed.</source>
        <translation>Son blok kaldırılamaz.</translation>
    </message>
    <message>
        <source>divisions along {axis}</source>
        <translation>{axis} boyunca bölünmeler</translation>
    </message>
    <message>
        <source>Block {block}, {what}: expected a number, got {text!r}</source>
        <translation>Blok {block}, {what}: sayı beklendi, {text!r} bulundu</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Seçenek</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Anahtar</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Değer</translation>
    </message>
    <message>
        <source>The file's ending is to be one of {known}</source>
        <translation>Dosyanın uzantısı şunlardan biri olmalı: {known}</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Resim</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Düz</translation>
    </message>
    <message>
        <source>Plot of {name}</source>
        <translation>{name} çizimi</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>İptal</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Durduruluyor</translation>
    </message>
    <message>
        <source>Measuring the mesh</source>
        <translation>Ağ ölçülüyor</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Ölçü</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>En kötü</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Ortalama</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>En iyi</translation>
    </message>
    <message>
        <source>Worst elements</source>
        <translation>En kötü elemanlar</translation>
    </message>
    <message>
        <source>length</source>
        <translation>uzunluk</translation>
    </message>
    <message>
        <source>area</source>
        <translation>alan</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>hacim</translation>
    </message>
    <message>
        <source>{count} elements from {low} to {high} are marked</source>
        <translation>{low} ile {high} arasında {count} eleman işaretli</translation>
    </message>
    <message>
        <source>Element {number} is marked</source>
        <translation>{number} numaralı eleman işaretli</translation>
    </message>
    <message>
        <source>Report of {name}</source>
        <translation>{name} raporu</translation>
    </message>
    <message>
        <source>{type} by {metric}; a click on a bar marks its elements</source>
        <translation>{metric} ölçüsüne göre {type}; bir sütuna tıklamak onun elemanlarını işaretler</translation>
    </message>
    <message>
        <source>{axis}: {low} to {high} mm</source>
        <translation>{axis}: {low} ile {high} mm arası</translation>
    </message>
    <message>
        <source>Shape library</source>
        <translation>Şekil kitaplığı</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Kare</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Daire</translation>
    </message>
    <message>
        <source>Cylinder surface</source>
        <translation>Silindir yüzeyi</translation>
    </message>
    <message>
        <source>Cone surface</source>
        <translation>Koni yüzeyi</translation>
    </message>
    <message>
        <source>Sphere surface</source>
        <translation>Küre yüzeyi</translation>
    </message>
    <message>
        <source>Torus surface</source>
        <translation>Simit yüzeyi</translation>
    </message>
    <message>
        <source>Cube</source>
        <translation>Küp</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kutu</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Silindir</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Koni</translation>
    </message>
    <message>
        <source>Tube</source>
        <translation>Boru</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Küre</translation>
    </message>
    <message>
        <source>Half ball</source>
        <translation>Yarım küre</translation>
    </message>
    <message>
        <source>Torus</source>
        <translation>Simit</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Kama</translation>
    </message>
    <message>
        <source>Choose a shape.</source>
        <translation>Bir şekil seçin.</translation>
    </message>
    <message>
        <source>1: linear elements</source>
        <translation>1: doğrusal elemanlar</translation>
    </message>
    <message>
        <source>2: quadratic elements</source>
        <translation>2: karesel elemanlar</translation>
    </message>
    <message>
        <source>Quality mesh of the boundary</source>
        <translation>Sınırın kaliteli ağı</translation>
    </message>
    <message>
        <source>Mesh of the boundary</source>
        <translation>Sınırın ağı</translation>
    </message>
    <message>
        <source>Mesh of the boundary, its triangles kept</source>
        <translation>Sınırın ağı, üçgenleri korunarak</translation>
    </message>
    <message>
        <source>Delaunay mesh of the points</source>
        <translation>Noktaların Delaunay ağı</translation>
    </message>
    <message>
        <source>Convex hull of the points</source>
        <translation>Noktaların dışbükey örtüsü</translation>
    </message>
    <message>
        <source>Own choice</source>
        <translation>Kendi seçimi</translation>
    </message>
</context>
<context>
    <name>NMGS_About</name>
    <message>
        <source>About NMGS</source>
        <translation>NMGS hakkında</translation>
    </message>
    <message>
        <source>Versions of the workbench and of everything that it is linked with</source>
        <translation>Çalışma tezgahının ve bağlı olduğu her şeyin sürümleri</translation>
    </message>
</context>
<context>
    <name>NMGS_Analysis</name>
    <message>
        <source>Static analysis</source>
        <translation>Statik çözümleme</translation>
    </message>
    <message>
        <source>Hold and load faces of the part that the picked mesh is on, and solve with CalculiX</source>
        <translation>Seçilen ağın üzerinde olduğu parçanın yüzeylerini tut ve yükle, CalculiX ile çöz</translation>
    </message>
</context>
<context>
    <name>NMGS_CutSolids</name>
    <message>
        <source>Cut solids</source>
        <translation>Katıları kes</translation>
    </message>
    <message>
        <source>Cut picked solids into pieces that blocks fill: by the faces and planes picked with them, or where it is proposed</source>
        <translation>Seçilen katıları blokların dolduracağı parçalara keser: birlikte seçilen yüzey ve düzlemlerle ya da önerilen yerlerden</translation>
    </message>
</context>
<context>
    <name>NMGS_Divisions</name>
    <message>
        <source>Divisions and grading</source>
        <translation>Bölünmeler ve sıklaştırma</translation>
    </message>
    <message>
        <source>Number and spacing of the elements along picked edges of blocks, and along their chains</source>
        <translation>Seçilen blok kenarları ve zincirleri boyunca elemanların sayısı ve aralığı</translation>
    </message>
</context>
<context>
    <name>NMGS_Examples</name>
    <message>
        <source>Examples</source>
        <translation>Örnekler</translation>
    </message>
    <message>
        <source>Ready documents to start from: each shows one way from geometry to a mesh</source>
        <translation>Başlamak için hazır belgeler: her biri geometriden ağa giden bir yolu gösterir</translation>
    </message>
</context>
<context>
    <name>NMGS_Export</name>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>Write the picked blocks or mesh to a file: N2S, N3S, N2R, N3R, TetGen, FEM formats</source>
        <translation>Seçilen blokları veya ağı dosyaya yazar: N2S, N3S, N2R, N3R, TetGen, FEM biçimleri</translation>
    </message>
</context>
<context>
    <name>NMGS_FitBlocks</name>
    <message>
        <source>Fit blocks to solids</source>
        <translation>Katılara blok oturt</translation>
    </message>
    <message>
        <source>Fill the picked solids, or the solids that own the picked faces, with 20-node blocks</source>
        <translation>Seçilen katıları veya seçilen yüzlerin katılarını 20 düğümlü bloklarla doldurur</translation>
    </message>
</context>
<context>
    <name>NMGS_FitPatches</name>
    <message>
        <source>Fit patches to faces</source>
        <translation>Yüzlere yama oturt</translation>
    </message>
    <message>
        <source>Lay 8-node patches over the picked faces, or over all faces of the picked objects</source>
        <translation>Seçilen yüzlere veya seçilen nesnelerin bütün yüzlerine 8 düğümlü yamalar serer</translation>
    </message>
</context>
<context>
    <name>NMGS_GenerateMesh</name>
    <message>
        <source>Generate mesh</source>
        <translation>Ağ oluştur</translation>
    </message>
    <message>
        <source>Divide the picked patches into quads, the picked blocks into hexahedra, as a FEM mesh</source>
        <translation>Seçilen yamaları dörtgenlere, seçilen blokları altıyüzlülere böler, FEM ağı olarak</translation>
    </message>
</context>
<context>
    <name>NMGS_Help</name>
    <message>
        <source>NMGS user guide</source>
        <translation>NMGS kullanıcı kılavuzu</translation>
    </message>
    <message>
        <source>The user guide: from a part to a mesh, every panel, file formats, the console</source>
        <translation>Kullanıcı kılavuzu: parçadan ağa, bütün paneller, dosya biçimleri, konsol</translation>
    </message>
</context>
<context>
    <name>NMGS_MeshReport</name>
    <message>
        <source>Mesh report</source>
        <translation>Ağ raporu</translation>
    </message>
    <message>
        <source>Counts, bounds, volume and quality of the picked mesh, with its worst elements</source>
        <translation>Seçilen ağın sayıları, sınırları, hacmi ve kalitesi, en kötü elemanlarıyla</translation>
    </message>
</context>
<context>
    <name>NMGS_NodeTable</name>
    <message>
        <source>Blocks by nodes</source>
        <translation>Düğümlerle bloklar</translation>
    </message>
    <message>
        <source>Type in patches of 8 nodes or blocks of 20 nodes, with a preview of their curved edges</source>
        <translation>8 düğümlü yamaları veya 20 düğümlü blokları elle girin; eğri kenarları önizlenir</translation>
    </message>
</context>
<context>
    <name>NMGS_Picture</name>
    <message>
        <source>Picture</source>
        <translation>Resim</translation>
    </message>
    <message>
        <source>The 3D view as PNG, PDF, SVG or on paper, with a title and axes</source>
        <translation>3B görünüm PNG, PDF, SVG olarak veya kağıda, başlık ve eksenlerle</translation>
    </message>
</context>
<context>
    <name>NMGS_PlotOptions</name>
    <message>
        <source>Plot options</source>
        <translation>Çizim seçenekleri</translation>
    </message>
    <message>
        <source>How the picked mesh is shown: split, by block directions, cut, shrunk, coloured by quality</source>
        <translation>Seçilen ağın nasıl gösterileceği: bölünmüş, blok yönlerine göre, kesilmiş, küçültülmüş, kaliteye göre renkli</translation>
    </message>
</context>
<context>
    <name>NMGS_ShapeLibrary</name>
    <message>
        <source>Shape library</source>
        <translation>Şekil kitaplığı</translation>
    </message>
    <message>
        <source>Ready-made blocks and patches: cylinders, balls, tori and others, chosen by picture</source>
        <translation>Hazır bloklar ve yamalar: silindirler, küreler, simitler ve diğerleri, resimle seçilir</translation>
    </message>
</context>
<context>
    <name>NMGS_TetGenMesh</name>
    <message>
        <source>TetGen mesh</source>
        <translation>TetGen ağı</translation>
    </message>
    <message>
        <source>Fill the picked solids, PLC, blocks or closed surface mesh with TetGen's tetrahedra</source>
        <translation>Seçilen katıları, PLC'yi, blokları veya kapalı yüzey ağını TetGen dörtyüzlüleriyle doldurur</translation>
    </message>
</context>
<context>
    <name>NMGS_Update</name>
    <message>
        <source>Update</source>
        <translation>Güncelle</translation>
    </message>
    <message>
        <source>Compute again the blocks and meshes whose geometry or divisions have changed</source>
        <translation>Geometrisi veya bölünmeleri değişen blokları ve ağları yeniden hesaplar</translation>
    </message>
</context>
<context>
    <name>analysis</name>
    <message>
        <source>Static analysis</source>
        <translation>Statik çözümleme</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Malzeme</translation>
    </message>
    <message>
        <source>Fills in the figures below, which can be changed</source>
        <translation>Aşağıdaki değerleri doldurur; değiştirilebilirler</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>Elastisite modülü</translation>
    </message>
    <message>
        <source>Stress by strain</source>
        <translation>Gerilme bölü gerinim</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>Poisson oranı</translation>
    </message>
    <message>
        <source>Strain across by strain along</source>
        <translation>Enine gerinim bölü boyuna gerinim</translation>
    </message>
    <message>
        <source>Faces that are held</source>
        <translation>Tutulan yüzeyler</translation>
    </message>
    <message>
        <source>None of their nodes can move; a double click takes a face away</source>
        <translation>Düğümlerinin hiçbiri hareket edemez; çift tıklama yüzeyi kaldırır</translation>
    </message>
    <message>
        <source>Hold picked faces</source>
        <translation>Seçilen yüzeyleri tut</translation>
    </message>
    <message>
        <source>Adds the faces that are picked in the view</source>
        <translation>Görünümde seçilen yüzeyleri ekler</translation>
    </message>
    <message>
        <source>Faces that are loaded</source>
        <translation>Yüklenen yüzeyler</translation>
    </message>
    <message>
        <source>They share the load; a double click takes a face away</source>
        <translation>Yükü paylaşırlar; çift tıklama yüzeyi kaldırır</translation>
    </message>
    <message>
        <source>Load picked faces</source>
        <translation>Seçilen yüzeylere yük ver</translation>
    </message>
    <message>
        <source>A force that all loaded faces share, or a pressure on each</source>
        <translation>Yüklenen tüm yüzeylerin paylaştığı bir kuvvet ya da her birine bir basınç</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kuvvet</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Basınç</translation>
    </message>
    <message>
        <source>All loaded faces together</source>
        <translation>Yüklenen tüm yüzeyler birlikte</translation>
    </message>
    <message>
        <source>Into the part</source>
        <translation>Parçanın içine doğru</translation>
    </message>
    <message>
        <source>The force goes along the straight edge, or the normal of the flat face, that is picked in the view; without any, into the loaded face</source>
        <translation>Kuvvet, görünümde seçilen düz kenar ya da düz yüzeyin normali boyuncadır; seçim yoksa yüklenen yüzeyin içine doğrudur</translation>
    </message>
    <message>
        <source>The other way round</source>
        <translation>Ters yönde</translation>
    </message>
    <message>
        <source>Turns the load's direction</source>
        <translation>Yükün yönünü çevirir</translation>
    </message>
    <message>
        <source>Solve with CalculiX</source>
        <translation>CalculiX ile çöz</translation>
    </message>
    <message>
        <source>Off: only the analysis is made, to go on with in the FEM workbench</source>
        <translation>Kapalı: yalnızca çözümleme hazırlanır, FEM tezgâhında sürdürülür</translation>
    </message>
</context>
<context>
    <name>blocking</name>
    <message>
        <source>Fit</source>
        <translation>Oturtma</translation>
    </message>
    <message>
        <source>Element size</source>
        <translation>Eleman boyu</translation>
    </message>
    <message>
        <source>Length of the mesh's elements that the divisions follow; 0 chooses one</source>
        <translation>Bölünmelerin uyduğu ağ elemanı uzunluğu; 0 kendisi seçer</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Largest distance from the CAD surface that the fit accepts; 0 chooses one</source>
        <translation>Oturtmanın kabul ettiği, CAD yüzeyinden en büyük uzaklık; 0 kendisi seçer</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Yöntem</translation>
    </message>
    <message>
        <source>How faces are covered and solids are cut; auto takes what gives the best elements</source>
        <translation>Yüzlerin nasıl kaplandığı ve katıların nasıl ayrıldığı; auto en iyi elemanları vereni alır</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Açıklama</translation>
    </message>
    <message>
        <source>Your own text, written into the files</source>
        <translation>Dosyalara yazılan kendi metniniz</translation>
    </message>
    <message>
        <source>A click selects the face or solid in the view</source>
        <translation>Tıklamak yüzü veya katıyı görünümde seçer</translation>
    </message>
    <message>
        <source>Cut the solids...</source>
        <translation>Katıları kes...</translation>
    </message>
    <message>
        <source>Takes these options, then proposes cuts into pieces that structured blocks fill</source>
        <translation>Bu seçenekleri alır, ardından yapılandırılmış blokların dolduracağı parçalara kesimler önerir</translation>
    </message>
    <message>
        <source>Lays the same blocks over the part again while only its dimensions change</source>
        <translation>Yalnızca ölçüler değiştikçe aynı blokları parçaya yeniden oturtur</translation>
    </message>
    <message>
        <source>Keep the layout when dimensions change</source>
        <translation>Ölçüler değişince yerleşimi koru</translation>
    </message>
    <message>
        <source>Divisions follow the element size</source>
        <translation>Bölünmeler eleman boyuna uyar</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Her bloğun her yönündeki eleman sayısı</translation>
    </message>
</context>
<context>
    <name>cuts</name>
    <message>
        <source>Cut solids</source>
        <translation>Katıları kes</translation>
    </message>
    <message>
        <source>Checked rows cut. Choose a row to see where. What is proposed goes through edges that stand in the way of blocks.</source>
        <translation>İşaretli satırlar keser. Yerini görmek için bir satır seçin. Öneriler, blokların önünde engel olan kenarlardan geçer.</translation>
    </message>
    <message>
        <source>Cuts, and how many of the edges and vertices in the way lie on each</source>
        <translation>Kesimler ve engel olan kenar ve köşelerin kaçının her birinin üzerinde olduğu</translation>
    </message>
    <message>
        <source>Add picked faces</source>
        <translation>Seçilen yüzeyleri ekle</translation>
    </message>
    <message>
        <source>Faces and planes that are picked in the view cut as well; planes and round faces go through the whole solid</source>
        <translation>Görünümde seçilen yüzey ve düzlemler de keser; düz ve yuvarlak yüzeyler katının tamamından geçer</translation>
    </message>
</context>
<context>
    <name>divisions</name>
    <message>
        <source>Divisions and grading</source>
        <translation>Bölünmeler ve sıklaştırma</translation>
    </message>
    <message>
        <source>Pick an edge of the blocks, or a row of the table.</source>
        <translation>Blokların bir kenarını veya tablonun bir satırını seçin.</translation>
    </message>
    <message>
        <source>Chains of edges that must have one number of elements</source>
        <translation>Eleman sayısı ortak olması gereken kenar zincirleri</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemanlar</translation>
    </message>
    <message>
        <source>Number of elements along every edge of the chain</source>
        <translation>Zincirin her kenarı boyunca eleman sayısı</translation>
    </message>
    <message>
        <source>Grading</source>
        <translation>Sıklaştırma</translation>
    </message>
    <message>
        <source>How the elements are spaced along the arrows</source>
        <translation>Elemanların oklar boyunca nasıl aralandığı</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Eşit</translation>
    </message>
    <message>
        <source>Geometric, by ratio</source>
        <translation>Geometrik, orana göre</translation>
    </message>
    <message>
        <source>Geometric, by first size</source>
        <translation>Geometrik, ilk boya göre</translation>
    </message>
    <message>
        <source>Geometric, by last size</source>
        <translation>Geometrik, son boya göre</translation>
    </message>
    <message>
        <source>Both ends, by ratio</source>
        <translation>İki uçtan, orana göre</translation>
    </message>
    <message>
        <source>Both ends, by sizes</source>
        <translation>İki uçtan, boylara göre</translation>
    </message>
    <message>
        <source>Hyperbolic tangent</source>
        <translation>Hiperbolik tanjant</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Oran</translation>
    </message>
    <message>
        <source>Each element is so many times as long as the one before</source>
        <translation>Her eleman bir öncekinin bu kadar katı uzunluktadır</translation>
    </message>
    <message>
        <source>First size</source>
        <translation>İlk boy</translation>
    </message>
    <message>
        <source>Length of the element at the arrow's tail</source>
        <translation>Okun başlangıcındaki elemanın uzunluğu</translation>
    </message>
    <message>
        <source>Last size</source>
        <translation>Son boy</translation>
    </message>
    <message>
        <source>Length of the element at the arrow's tip</source>
        <translation>Okun ucundaki elemanın uzunluğu</translation>
    </message>
    <message>
        <source>Turn round</source>
        <translation>Ters çevir</translation>
    </message>
    <message>
        <source>Grade from the other end</source>
        <translation>Öbür uçtan başla</translation>
    </message>
</context>
<context>
    <name>export</name>
    <message>
        <source>Export</source>
        <translation>Dışa aktar</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Biçim</translation>
    </message>
    <message>
        <source>Formats that can hold what is picked</source>
        <translation>Seçileni tutabilen biçimler</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Dosya</translation>
    </message>
    <message>
        <source>File to write; its ending follows the format</source>
        <translation>Yazılacak dosya; uzantısı biçime uyar</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Gözat...</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Derece</translation>
    </message>
    <message>
        <source>Elements with or without mid-side nodes</source>
        <translation>Kenar ortası düğümleri olan veya olmayan elemanlar</translation>
    </message>
    <message>
        <source>As it is</source>
        <translation>Olduğu gibi</translation>
    </message>
    <message>
        <source>1: linear elements</source>
        <translation>1: doğrusal elemanlar</translation>
    </message>
    <message>
        <source>2: quadratic elements</source>
        <translation>2: karesel elemanlar</translation>
    </message>
    <message>
        <source>Split into triangles or tetrahedra</source>
        <translation>Üçgenlere veya dörtyüzlülere böl</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruplar</translation>
    </message>
    <message>
        <source>Groups of nodes and elements to write</source>
        <translation>Yazılacak düğüm ve eleman grupları</translation>
    </message>
</context>
<context>
    <name>node_table</name>
    <message>
        <source>Blocks by nodes</source>
        <translation>Düğümlerle bloklar</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tür</translation>
    </message>
    <message>
        <source>Patches of 8 nodes</source>
        <translation>8 düğümlü yamalar</translation>
    </message>
    <message>
        <source>Blocks of 20 nodes</source>
        <translation>20 düğümlü bloklar</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Açıklama</translation>
    </message>
    <message>
        <source>Your own text, written into the files</source>
        <translation>Dosyalara yazılan kendi metniniz</translation>
    </message>
    <message>
        <source>Add a block</source>
        <translation>Blok ekle</translation>
    </message>
    <message>
        <source>Appends a block beside the last one</source>
        <translation>Sonuncunun yanına bir blok ekler</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Kaldır</translation>
    </message>
    <message>
        <source>Removes the block of the row that is chosen</source>
        <translation>Seçilen satırın bloğunu kaldırır</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Düzleştir</translation>
    </message>
    <message>
        <source>Puts the mid-side nodes of the chosen block into the middle of their edges</source>
        <translation>Seçilen bloğun kenar ortası düğümlerini kenarlarının ortasına koyar</translation>
    </message>
    <message>
        <source>Coordinates of the nodes: corners first, then mid-side nodes, as the thesis numbers them</source>
        <translation>Düğümlerin koordinatları: önce köşeler, sonra kenar ortaları, tezdeki numaralarla</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Her bloğun her yönündeki eleman sayısı</translation>
    </message>
</context>
<context>
    <name>picture</name>
    <message>
        <source>Picture</source>
        <translation>Resim</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Dosya</translation>
    </message>
    <message>
        <source>PNG, PDF or SVG by its ending</source>
        <translation>Uzantısına göre PNG, PDF veya SVG</translation>
    </message>
    <message>
        <source>Browse...</source>
        <translation>Gözat...</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Başlık</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Genişlik</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Yükseklik</translation>
    </message>
    <message>
        <source>Axes and their lengths</source>
        <translation>Eksenler ve uzunlukları</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Arka plan</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Beyaz</translation>
    </message>
    <message>
        <source>As in the view</source>
        <translation>Görünümdeki gibi</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Saydam</translation>
    </message>
    <message>
        <source>Print...</source>
        <translation>Yazdır...</translation>
    </message>
</context>
<context>
    <name>plot</name>
    <message>
        <source>Plot options</source>
        <translation>Çizim seçenekleri</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Göster</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>Elemanlar</translation>
    </message>
    <message>
        <source>Triangles or tetrahedra</source>
        <translation>Üçgenler veya dörtyüzlüler</translation>
    </message>
    <message>
        <source>Faces across</source>
        <translation>Şu yöne dik yüzler</translation>
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
        <translation>Renklendirme</translation>
    </message>
    <message>
        <source>A metric of quality, with its legend</source>
        <translation>Bir kalite ölçüsü, göstergesiyle</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Şu eksene dik kes</translation>
    </message>
    <message>
        <source>Leaves out the elements on one side of a plane</source>
        <translation>Bir düzlemin bir yanındaki elemanları çizmez</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Yok</translation>
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
        <translation>Kesit yeri</translation>
    </message>
    <message>
        <source>Keep the other side</source>
        <translation>Öbür yanı tut</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Küçült</translation>
    </message>
    <message>
        <source>Draws each element smaller, so that all are seen</source>
        <translation>Her elemanı küçük çizer, böylece hepsi görünür</translation>
    </message>
    <message>
        <source>Number of elements on the edges of the blocks</source>
        <translation>Blok kenarlarında eleman sayısı</translation>
    </message>
</context>
<context>
    <name>preferences</name>
    <message>
        <source>General</source>
        <translation>Genel</translation>
    </message>
    <message>
        <source>Recompute blocks and meshes at once</source>
        <translation>Blokları ve ağları hemen yeniden hesapla</translation>
    </message>
    <message>
        <source>Off: what depends on a change is marked as stale until it is updated</source>
        <translation>Kapalı: değişiklikten etkilenenler güncellenene kadar eskimiş olarak işaretlenir</translation>
    </message>
    <message>
        <source>Show the number of elements on the edges of new blocks</source>
        <translation>Yeni blokların kenarlarında eleman sayısını göster</translation>
    </message>
    <message>
        <source>Quality below which a mesh is warned of</source>
        <translation>Altında uyarı verilen ağ kalitesi</translation>
    </message>
    <message>
        <source>Worst scaled Jacobian</source>
        <translation>En kötü ölçekli Jacobi değeri</translation>
    </message>
    <message>
        <source>Elements that FreeCAD's own view is given at most</source>
        <translation>FreeCAD'in kendi görünümüne verilecek en çok eleman</translation>
    </message>
    <message>
        <source>Larger meshes are handed to FEM when an analysis takes them</source>
        <translation>Daha büyük ağlar, bir analiz aldığında FEM'e verilir</translation>
    </message>
    <message>
        <source>Time limit of TetGen, s</source>
        <translation>TetGen süre sınırı, s</translation>
    </message>
    <message>
        <source>For new TetGen meshes; 0 for none</source>
        <translation>Yeni TetGen ağları için; yoksa 0</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>Mesh report</source>
        <translation>Ağ raporu</translation>
    </message>
    <message>
        <source>Choose a metric to see how its values are spread</source>
        <translation>Değerlerinin dağılımını görmek için bir ölçü seçin</translation>
    </message>
    <message>
        <source>Elements by value; a click on a bar marks its elements in the view</source>
        <translation>Değere göre elemanlar; bir sütuna tıklamak onun elemanlarını görünümde işaretler</translation>
    </message>
    <message>
        <source>The worst elements; a click zooms to one</source>
        <translation>En kötü elemanlar; tıklamak birine yaklaştırır</translation>
    </message>
    <message>
        <source>Colour the mesh by this metric</source>
        <translation>Ağı bu ölçüye göre renklendir</translation>
    </message>
</context>
<context>
    <name>shape_library</name>
    <message>
        <source>Shape library</source>
        <translation>Şekil kitaplığı</translation>
    </message>
    <message>
        <source>Ready-made blocks; choose one</source>
        <translation>Hazır bloklar; birini seçin</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Boyut</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Uzunluk</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Genişlik</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Yarıçap</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>İç yarıçap</translation>
    </message>
    <message>
        <source>Top radius</source>
        <translation>Üst yarıçap</translation>
    </message>
    <message>
        <source>Tube radius</source>
        <translation>Boru yarıçapı</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Yükseklik</translation>
    </message>
    <message>
        <source>Divisions</source>
        <translation>Bölünmeler</translation>
    </message>
    <message>
        <source>Number of elements along each direction of each block</source>
        <translation>Her bloğun her yönündeki eleman sayısı</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Parçalar</translation>
    </message>
    <message>
        <source>Blocks into which each block is cut; more of them follow round shapes better</source>
        <translation>Her bloğun kesildiği blok sayısı; çoğu yuvarlak şekillere daha iyi uyar</translation>
    </message>
    <message>
        <source>Caps</source>
        <translation>Kapaklar</translation>
    </message>
    <message>
        <source>With both ends</source>
        <translation>İki ucuyla</translation>
    </message>
</context>
<context>
    <name>structured_mesh</name>
    <message>
        <source>Structured mesh</source>
        <translation>Yapılı ağ</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Derece</translation>
    </message>
    <message>
        <source>Split into triangles or tetrahedra</source>
        <translation>Üçgenlere veya dörtyüzlülere böl</translation>
    </message>
    <message>
        <source>Put the nodes onto the CAD surface</source>
        <translation>Düğümleri CAD yüzeyine koy</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerans</translation>
    </message>
    <message>
        <source>Nodes of different blocks closer than this are one; 0 chooses it</source>
        <translation>Farklı blokların bundan yakın düğümleri birdir; 0 kendisi seçer</translation>
    </message>
</context>
<context>
    <name>tetgen_mesh</name>
    <message>
        <source>TetGen mesh</source>
        <translation>TetGen ağı</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Ön ayar</translation>
    </message>
    <message>
        <source>Kinds of mesh to start from; what is set by hand below is replaced</source>
        <translation>Başlamak için ağ türleri; aşağıda elle ayarlananlar değişir</translation>
    </message>
    <message>
        <source>Switches</source>
        <translation>Anahtarlar</translation>
    </message>
    <message>
        <source>TetGen's switches, for example pq1.2a5: p fill a boundary, q quality, a largest volume</source>
        <translation>TetGen anahtarları, örneğin pq1.2a5: p bir sınırı doldur, q kalite, a en büyük hacim</translation>
    </message>
    <message>
        <source>Every option of TetGen by name, with its letter; pointing at one tells what it does</source>
        <translation>TetGen'in her seçeneği, adı ve harfiyle; üzerine gelince ne yaptığı görünür</translation>
    </message>
    <message>
        <source>Time limit, s</source>
        <translation>Süre sınırı, s</translation>
    </message>
    <message>
        <source>Seconds after which TetGen is stopped; 0 for no limit</source>
        <translation>TetGen'in durdurulacağı saniye; sınır yoksa 0</translation>
    </message>
    <message>
        <source>TetGen's own words appear here after Apply.</source>
        <translation>Uygula'dan sonra TetGen'in kendi iletileri burada görünür.</translation>
    </message>
</context>
</TS>
