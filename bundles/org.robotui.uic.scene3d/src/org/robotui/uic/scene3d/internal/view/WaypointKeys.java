package org.robotui.uic.scene3d.internal.view;

import java.util.OptionalInt;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.scene3d.internal.SceneParts;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

/** What keys do with waypoints: with the selected one, and with all of them. Display thread. */
final class WaypointKeys {
  private final SceneSurface scene;
  private final SceneParts parts;

  WaypointKeys(SceneSurface scene, SceneParts parts) {
    this.scene = scene;
    this.parts = parts;
  }

  /** True where the key was for waypoints. */
  boolean key(Event e) {
    return chosen(e) || all(e);
  }

  private boolean chosen(Event e) {
    OptionalInt index =
        parts.picks().selection().filter(s -> s.display().equals(Waypoints.DISPLAY)).map(s -> Waypoints.index(s.part()))
            .orElseGet(OptionalInt::empty);
    if (index.isEmpty()) {
      return false;
    }
    switch (e.keyCode) {
      case SWT.DEL, SWT.BS -> parts.model().soon(() -> parts.waypoints().remove(index.getAsInt()));
      case SWT.PAGE_UP -> parts.model().soon(() -> parts.waypoints().move(index.getAsInt(), -1));
      case SWT.PAGE_DOWN -> parts.model().soon(() -> parts.waypoints().move(index.getAsInt(), 1));
      default -> {
        return false;
      }
    }
    return true;
  }

  private boolean all(Event e) {
    boolean driving = parts.waypoints().tour().driving().isPresent();
    boolean tool = scene.tools().using(ToolKind.WAYPOINTS);
    if (e.keyCode == 'z' && (e.stateMask & SWT.MOD1) != 0) {
      undo();
      return true;
    }
    if ((tool || driving) && (e.keyCode == SWT.CR || e.keyCode == SWT.KEYPAD_CR)) {
      drive();
      return true;
    }
    return false;
  }

  void undo() {
    parts.model().soon(() -> scene.say(parts.waypoints().undo()));
  }

  /** Begins with the first one; ends where the robot drives. */
  void drive() {
    if (parts.waypoints().tour().driving().isPresent()) {
      parts.waypoints().tour().halt();
    } else if (parts.waypoints().route().poses().isEmpty()) {
      scene.say(new CommandNotice(Health.BAD, "There is no waypoint to drive to: press into the scene to place one"));
    } else {
      parts.waypoints().tour().start(0);
    }
  }
}
