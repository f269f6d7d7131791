package org.robotui.urdf.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.robotui.urdf.internal.Refusal;
import org.robotui.urdf.internal.mesh.ColladaReader;
import org.robotui.urdf.internal.mesh.MeshBuilder;
import org.robotui.urdf.internal.mesh.ObjReader;
import org.robotui.urdf.internal.mesh.Pictures;
import org.robotui.urdf.internal.mesh.StlReader;

/**
 * Reads meshes: STL (binary and ASCII), OBJ with MTL, COLLADA, with the PNG and JPEG pictures of their surfaces. A mesh
 * has 20 million triangles and 512 MB at most. Corners without normals get those of their triangles. The
 * {@code up_axis} of COLLADA files is not followed, as RViz and Gazebo do not: models are written for that; their
 * {@code unit} is.
 */
public final class MeshReader {
  private MeshReader() {}

  /**
   * Reads a file.
   *
   * @param name of the file, whose ending says how it is written
   * @param bytes what is in it
   * @param beside gives the bytes of a file beside it (materials of an OBJ, pictures); empty where there is none
   * @return the mesh, or why not
   */
  public static MeshRead read(String name, byte[] bytes, Function<String, Optional<byte[]>> beside) {
    List<String> warnings = new ArrayList<>();
    try {
      MeshBuilder builder = new MeshBuilder();
      String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
      switch (ending) {
        case "stl", "stlb" -> StlReader.read(bytes, builder);
        case "obj" -> new ObjReader(builder, warnings, beside).read(bytes);
        case "dae" -> new ColladaReader(builder, warnings).read(bytes);
        default -> throw new Refusal(0, "meshes of the kind ." + ending + " are not read, must be .stl, .dae or .obj");
      }
      Mesh mesh = builder.build();
      return new MeshRead.Ok(mesh, new Pictures(warnings, beside).read(mesh), warnings);
    } catch (Refusal refusal) {
      return new MeshRead.Refused(
          refusal.line() > 0 ? "line " + refusal.line() + ": " + refusal.getMessage() : refusal.getMessage());
    }
  }
}
