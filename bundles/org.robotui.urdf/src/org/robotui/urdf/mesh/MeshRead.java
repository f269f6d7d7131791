package org.robotui.urdf.mesh;

import java.util.List;
import java.util.Map;

/** What came of reading a file. */
public sealed interface MeshRead {
  /**
   * It was read.
   *
   * @param mesh the surface
   * @param pictures those of its textures that could be read, by their names in the parts
   * @param warnings what was wrong but could be passed over
   */
  record Ok(Mesh mesh, Map<String, Picture> pictures, List<String> warnings) implements MeshRead {
    /**
     * Copies map and list.
     *
     * @param mesh the surface
     * @param pictures of its textures
     * @param warnings passed over
     */
    public Ok {
      pictures = Map.copyOf(pictures);
      warnings = List.copyOf(warnings);
    }
  }

  /**
   * It cannot be used.
   *
   * @param why what is wrong, with the line where there is one
   */
  record Refused(String why) implements MeshRead {}
}
