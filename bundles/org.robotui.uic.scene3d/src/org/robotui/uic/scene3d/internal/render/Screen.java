package org.robotui.uic.scene3d.internal.render;

import org.robotui.gl.render.Rendered;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

/** Where pictures are shown. */
@FunctionalInterface
public interface Screen {
  /**
   * Takes a picture. On the thread that hands pictures over, one at a time: the next one may be drawn meanwhile, and
   * waits there.
   *
   * @param picture whose pixels are written anew after the call: what is needed of them is copied
   * @param from where it was seen from
   */
  void take(Rendered.Picture picture, CameraPose from);
}
