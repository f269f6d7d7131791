package org.robotui.urdf.mesh;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Small meshes in all kinds of files. */
final class MeshSamples {
  static final String ASCII_STL = """
      solid two facets
       facet normal 0 0 1
        outer loop
         vertex 0 0 0
         vertex 1 0 0
         vertex 0 1 0
        endloop
       endfacet
       facet normal 0 0 0
        outer loop
         vertex 0 0 0
         vertex 0 1 0
         vertex 0 0 1
        endloop
       endfacet
      endsolid two facets
      """;
  static final String OBJ = """
      # a square and a triangle
      mtllib looks.mtl
      v 0 0 0
      v 1 0 0
      v 1 1 0
      v 0 1 0
      vn 0 0 1
      usemtl red
      f 1//1 2//1 3//1 4//1
      usemtl glass
      f -4 -3 -2
      """;
  static final String MTL = "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 1 0\nd 0.25\nmap_Kd glass.png\n";

  private static final String DAE = """
      <?xml version="1.0" encoding="utf-8"?>
      <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
      <asset><unit meter="0.01"/><up_axis>Y_UP</up_axis></asset>
      <library_images><image id="wood"><init_from>wood.png</init_from></image></library_images>
      <library_effects><effect id="fx"><profile_COMMON><technique sid="c"><lambert><diffuse><color>0 0.5 1 1</color></diffuse>
       <transparent opaque="A_ONE"><color>1 1 1 1</color></transparent><transparency><float>0.5</float></transparency></lambert></technique></profile_COMMON></effect>
       <effect id="pic"><profile_COMMON><newparam sid="s"><surface type="2D"><init_from>wood</init_from></surface></newparam>
       <newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
       <technique sid="c"><phong><diffuse><texture texture="t" texcoord="UV"/></diffuse></phong></technique></profile_COMMON></effect></library_effects>
      <library_materials><material id="mat"><instance_effect url="#fx"/></material><material id="pm"><instance_effect url="#pic"/></material></library_materials>
      <library_geometries><geometry id="g"><mesh>
       <source id="p"><float_array id="pa" count="12">0 0 0 100 0 0 100 100 0 0 100 0</float_array>
        <technique_common><accessor source="#pa" count="4" stride="3"/></technique_common></source>
       <source id="n"><float_array count="3">0 0 1</float_array><technique_common><accessor stride="3"/></technique_common></source>
       <source id="u"><float_array count="2">0.5 0.25</float_array><technique_common><accessor stride="2"/></technique_common></source>
       <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
       PRIMITIVE
      </mesh></geometry></library_geometries>
      <library_nodes><node id="shared"><instance_geometry url="#g"><bind_material><technique_common>
       <instance_material symbol="sym" target="#mat"/><instance_material symbol="psym" target="#pm"/></technique_common></bind_material></instance_geometry></node></library_nodes>
      <library_visual_scenes><visual_scene id="s"><node>
       <translate>0 0 200</translate><rotate>0 0 1 90</rotate><scale>2 2 2</scale><node><instance_node url="#shared"/></node></node></visual_scene></library_visual_scenes>
      <scene><instance_visual_scene url="#s"/></scene></COLLADA>
      """;

  private MeshSamples() {}

  static byte[] dae(String primitive) {
    return DAE.replace("PRIMITIVE", primitive).getBytes(StandardCharsets.UTF_8);
  }

  static byte[] triangles() {
    return dae("<triangles count=\"2\" material=\"sym\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
        + "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/><p>0 0 1 0 2 0 0 0 2 0 3 0</p></triangles>");
  }

  static byte[] binaryStl(int declared, int written) {
    ByteBuffer bytes = ByteBuffer.allocate(84 + 50 * written).order(ByteOrder.LITTLE_ENDIAN);
    bytes.put("solid but binary".getBytes(StandardCharsets.US_ASCII));
    bytes.putInt(80, declared);
    for (int i = 0; i < written; i++) {
      bytes.position(84 + 50 * i);
      for (float number : new float[]{0, 0, 2, i, 0, 0, i + 1, 0, 0, i, 1, 0}) {
        bytes.putFloat(number);
      }
    }
    return bytes.array();
  }

  static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  static Optional<byte[]> mtl(String name) {
    return name.equals("looks.mtl") ? Optional.of(bytes(MTL)) : Optional.empty();
  }
}
