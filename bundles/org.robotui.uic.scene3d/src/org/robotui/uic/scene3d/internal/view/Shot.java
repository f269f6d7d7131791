package org.robotui.uic.scene3d.internal.view;

import java.util.List;
import org.robotui.gl.render.Rendered;
import org.robotui.ui.LiveImage;
import org.robotui.uic.scene3d.internal.camera.CameraPose;

/**
 * A picture that is shown, and how it came about.
 *
 * @param from where it was seen from
 * @param figures how it was made
 * @param problems parts that could not be drawn
 * @param image its pixels
 */
record Shot(CameraPose from, Rendered.Figures figures, List<String> problems, LiveImage image) {}
