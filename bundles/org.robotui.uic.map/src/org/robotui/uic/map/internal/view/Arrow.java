package org.robotui.uic.map.internal.view;

import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.ui.scene.Painter;

/** An arrow of a size in pixels. */
final class Arrow {
  private Arrow() {}

  static void paint(Painter painter, RigidTransform pose, double length, double head) {
    double unit = 1 / painter.viewport().scale();
    Vector3 from = pose.translation();
    Vector3 tip = pose.apply(new Vector3(length * unit, 0, 0));
    Vector3 left = pose.apply(new Vector3((length - head) * unit, head * 0.6 * unit, 0));
    Vector3 right = pose.apply(new Vector3((length - head) * unit, -head * 0.6 * unit, 0));
    painter.line(from.x(), from.y(), tip.x(), tip.y());
    painter.area(new double[]{tip.x(), tip.y(), left.x(), left.y(), right.x(), right.y()}, 3);
  }
}
