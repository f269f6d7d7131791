package org.robotui.uic.scene3d.internal.studio;

import org.robotui.gl.render.Rendered;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

/** Where pictures are shown. */
@FunctionalInterface
public interface Screen {
  /**
   * Takes a picture. On the thread of OpenGL: no other picture is drawn meanwhile.
   *
   * @param picture whose pixels are written anew after the call: what is needed of them is copied
   * @param from where it was seen from
   */
  void take(Rendered.Picture picture, CameraPose from);
}
