package org.robotui.urdf.mesh;

import java.util.List;

/** What came of reading a file. */
public sealed interface MeshRead {
  /**
   * It was read.
   *
   * @param mesh the surface
   * @param warnings what was wrong but could be passed over
   */
  record Ok(Mesh mesh, List<String> warnings) implements MeshRead {
    /**
     * Copies the list.
     *
     * @param mesh the surface
     * @param warnings passed over
     */
    public Ok {
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
