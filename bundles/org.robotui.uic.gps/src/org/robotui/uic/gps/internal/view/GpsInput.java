package org.robotui.uic.gps.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.scene.SceneHands;

/** Mouse and keys of the view. Display thread. */
final class GpsInput {
  private final GpsCanvas view;
  private final PaintedCanvas surface;

  GpsInput(GpsCanvas view, PaintedCanvas surface) {
    this.view = view;
    this.surface = surface;
  }

  void listen() {
    new SceneHands(surface, view.mover().held(view::click));
    surface.addListener(SWT.MouseMove, e -> view.point(Optional.of(new Point(e.x, e.y))));
    surface.addListener(SWT.MouseExit, e -> view.point(Optional.empty()));
    surface.addListener(SWT.MenuDetect, this::menu);
    surface.addListener(SWT.KeyDown, this::key);
  }

  private void menu(Event e) {
    e.doit = false;
    view.openMenu();
  }

  private void key(Event e) {
    switch (Character.toLowerCase(e.character)) {
      case 'f' -> view.toggleFollow();
      case 'm' -> view.toggleRuler();
      case 'c' -> view.copy();
      case 'd' -> view.toggleWords();
      case 'l' -> view.toggleList();
      case SWT.ESC -> endRuler();
      default -> {}
    }
  }

  private void endRuler() {
    if (view.measuring()) {
      view.toggleRuler();
    }
  }
}
