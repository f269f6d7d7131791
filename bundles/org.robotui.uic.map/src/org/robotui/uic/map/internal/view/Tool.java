package org.robotui.uic.map.internal.view;

import org.robotui.ui.scene.Painter;

/** What the left button does, in place of moving the map. World coordinates, display thread. */
interface Tool {
  /** The id of the action that switches it. */
  String id();

  /** How it is used, one line. */
  String hint();

  void down(double x, double y);

  void drag(double x, double y);

  void up(double x, double y);

  /** The pointer moves while no button is held. */
  default void hover(double x, double y) {
    // Most tools have nothing to show before a button is pressed.
  }

  void paint(Painter painter);
}
