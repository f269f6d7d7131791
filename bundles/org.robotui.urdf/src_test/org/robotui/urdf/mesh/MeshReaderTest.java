package org.robotui.urdf.mesh;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.urdf.Color;

class MeshReaderTest {
  private static MeshRead.Ok read(String name, byte[] bytes) {
    MeshRead read = MeshReader.read(name, bytes, MeshSamples::mtl);
    return assertInstanceOf(MeshRead.Ok.class, read, read.toString());
  }

  private static String refused(String name, byte[] bytes) {
    return assertInstanceOf(MeshRead.Refused.class, MeshReader.read(name, bytes, file -> Optional.empty())).why();
  }

  private static float[] three(FloatBuffer numbers, int index) {
    return new float[]{numbers.get(3 * index), numbers.get(3 * index + 1), numbers.get(3 * index + 2)};
  }

  @Test
  void readsBinaryStlAlsoWhereItBeginsWithSolid() {
    Mesh mesh = read("A.STL", MeshSamples.binaryStl(3, 3)).mesh();
    assertEquals(9, mesh.triangles().remaining());
    assertArrayEquals(new float[]{3, 0, 0}, three(mesh.xyz(), 7));
    assertArrayEquals(new float[]{0, 0, 1}, three(mesh.normals(), 7));
  }

  @Test
  void readsAsciiStlAndComputesNormalsThatAreMissing() {
    Mesh mesh = read("a.stl", MeshSamples.bytes(MeshSamples.ASCII_STL)).mesh();
    assertEquals(6, mesh.triangles().remaining());
    assertArrayEquals(new float[]{1, 0, 0}, three(mesh.normals(), 4));
  }

  @Test
  void believesNoDeclaredCount() {
    assertTrue(refused("a.stl", MeshSamples.binaryStl(-1, 2)).contains("declares 4294967295 triangles"));
    byte[] bytes = MeshSamples.binaryStl(2_000_000_000, 2);
    bytes[0] = 'b';
    assertTrue(refused("a.stl", bytes).contains("declares 2000000000 triangles"));
    assertTrue(refused("a.dae",
        MeshSamples
            .dae("<triangles count='9'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 7</p></triangles>"))
        .contains("has the index 7, but there are 4"));
  }

  @Test
  void readsObjWithColoursOfItsMaterials() {
    Mesh mesh = read("a.obj", MeshSamples.bytes(MeshSamples.OBJ)).mesh();
    assertEquals(9, mesh.triangles().remaining());
    assertEquals(7, mesh.xyz().remaining() / 3, "corners of the square are shared");
    assertEquals(List.of(
        new Mesh.Part(0, 4, 0, 2, Optional.of(new Color(1, 0, 0, 1)), Optional.empty()),
        new Mesh.Part(4, 3, 2, 1, Optional.of(new Color(0, 1, 0, 0.25f)), Optional.of("glass.png"))), mesh.parts());
    assertArrayEquals(new float[]{0, 0, 1}, three(mesh.normals(), 6));
  }

  @Test
  void saysThatMaterialsOfAnObjAreMissing() {
    MeshRead.Ok read = assertInstanceOf(MeshRead.Ok.class,
        MeshReader.read("a.obj", MeshSamples.bytes(MeshSamples.OBJ), name -> Optional.empty()));
    assertTrue(read.warnings().get(0).contains("looks.mtl"));
  }

  @Test
  void followsNodesUnitsAndMaterialsOfColladaButNotItsUpAxis() {
    Mesh mesh = read("a.dae", MeshSamples.triangles()).mesh();
    assertEquals(6, mesh.triangles().remaining());
    assertEquals(4, mesh.xyz().remaining() / 3);
    // (100, 0, 0) scaled by 2, turned by 90 degrees, lifted by 200, all in centimetres
    assertArrayEquals(new float[]{0, 2, 2}, three(mesh.xyz(), 1), 1e-6f);
    assertArrayEquals(new float[]{0, 0, 1}, three(mesh.normals(), 1), 1e-6f);
    assertEquals(Optional.of(new Color(0, 0.5f, 1, 0.5f)), mesh.parts().get(0).color());
  }

  @ParameterizedTest
  @ValueSource(strings = {
      "<polylist count='1' material='psym'><input semantic='VERTEX' source='#v' offset='0'/><input semantic='TEXCOORD' source='#u' offset='1'/><vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>",
      "<polygons count='1' material='psym'><input semantic='VERTEX' source='#v' offset='0'/><input semantic='TEXCOORD' source='#u' offset='1'/><p>0 0 1 0 2 0 3 0</p></polygons>",
      "<trifans count='1' material='psym'><input semantic='VERTEX' source='#v' offset='0'/><input semantic='TEXCOORD' source='#u' offset='1'/><p>0 0 1 0 2 0 3 0</p></trifans>",
      "<tristrips count='1' material='psym'><input semantic='VERTEX' source='#v' offset='0'/><input semantic='TEXCOORD' source='#u' offset='1'/><p>0 0 1 0 3 0 2 0</p></tristrips>"})
  void cutsPolygonsOfColladaIntoTriangles(String primitive) {
    Mesh mesh = read("a.dae", MeshSamples.dae(primitive)).mesh();
    assertEquals(6, mesh.triangles().remaining());
    assertArrayEquals(new float[]{0, 0, 1}, new float[]{0, 0, Math.abs(mesh.normals().get(2))});
    assertEquals(Optional.of("wood.png"), mesh.parts().get(0).texture());
    assertEquals(0.25f, mesh.uv().orElseThrow().get(1));
  }

  private static MeshRead.Ok textured(String text, Map<String, byte[]> files) {
    MeshRead read = MeshReader.read("a.obj", MeshSamples.bytes(text), name -> Optional.ofNullable(files.get(name)));
    return assertInstanceOf(MeshRead.Ok.class, read, read.toString());
  }

  @Test
  void readsThePicturesOfSurfaces() {
    String obj = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\nf 1/1 2/2 3/3\n";
    byte[] mtl = MeshSamples.bytes("newmtl m\nKd 1 1 1\nmap_Kd -s 1 1 1 -clamp on my skin.png\n");
    MeshRead.Ok read = textured(obj, Map.of("a.mtl", mtl, "my skin.png", PictureSamples.file("png", 4, 2)));
    assertEquals(List.of(), read.warnings());
    assertEquals(4, read.pictures().get("my skin.png").width());
    assertArrayEquals(new float[]{1, 1},
        new float[]{read.mesh().uv().orElseThrow().get(4), read.mesh().uv().orElseThrow().get(5)});
    assertEquals(List.of("its picture 'my skin.png' is not shown: there is no such file in its package"),
        textured(obj, Map.of("a.mtl", mtl)).warnings());
    assertEquals(List.of("its picture 'my skin.png' is not shown: it is neither PNG nor JPEG"),
        textured(obj, Map.of("a.mtl", mtl, "my skin.png", new byte[9])).warnings());
  }

  @Test
  void picturesOfColladaAreUris() {
    String triangles = "<triangles count='1' material='psym'><input semantic='VERTEX' source='#v' offset='0'/>"
        + "<input semantic='TEXCOORD' source='#u' offset='1'/><p>0 0 1 0 2 0</p></triangles>";
    byte[] dae = MeshSamples
        .bytes(new String(MeshSamples.dae(triangles), StandardCharsets.UTF_8).replace("wood.png", "../my%20wood.png"));
    MeshRead read = MeshReader.read("a.dae", dae,
        name -> Optional.of(name).filter("../my wood.png"::equals).map(n -> PictureSamples.file("jpeg", 4, 4)));
    assertEquals(Set.of("../my%20wood.png"), assertInstanceOf(MeshRead.Ok.class, read).pictures().keySet());
  }

  @Test
  void refusesNodesThatContainThemselves() {
    String text =
        "<COLLADA><library_nodes><node id='n'><instance_node url='#n'/><instance_node url='#n'/></node></library_nodes>"
            + "<library_visual_scenes><visual_scene><node><instance_node url='#n'/></node></visual_scene></library_visual_scenes></COLLADA>";
    assertTrue(refused("a.dae", MeshSamples.bytes(text)).contains("contain themselves"));
  }

  @Test
  void refusesOtherKindsAndEmptyFilesInWords() {
    assertTrue(refused("a.blend", new byte[0]).contains("must be .stl, .dae or .obj"));
    assertTrue(refused("a.obj", new byte[0]).contains("no triangle"));
    assertTrue(refused("a.stl", new byte[3]).contains("no STL"));
    assertTrue(
        refused("a.obj", MeshSamples.bytes("v 0 0 0\nv NaN 0 0\nv 1 1 1\nf 1 2 3")).contains("no finite number"));
  }
}
