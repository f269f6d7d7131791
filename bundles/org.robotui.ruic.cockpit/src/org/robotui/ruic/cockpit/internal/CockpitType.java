package org.robotui.ruic.cockpit.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.FixedRuicType;
import org.robotui.api.RuicType;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout.View;

/**
 * The user interface of a robot that somebody drives by hand: the picture of its camera, below it the stick, and beside
 * them map and status. Views are named by the ids of their types; one that is not installed is left out.
 */
@Component(service = RuicType.class)
public final class CockpitType extends FixedRuicType {

  private static final Layout FRONT =
      new Split(Direction.COLUMN, List.of(new View("camera"), new View("teleop")), List.of(70.0, 30.0));

  private static final Layout BESIDE = new Split(Direction.COLUMN,
      List.of(new View("map"), new Tabs(List.of("status", "connections"))), List.of(60.0, 40.0));

  private static final Layout LAYOUT = new Split(Direction.ROW, List.of(FRONT, BESIDE), List.of(60.0, 40.0));

  /** Made by the framework. The view for terminals has no place in the layout of a window. */
  public CockpitType() {
    super("cockpit", "Cockpit", "Camera and teleoperation of a robot that is driven by hand, with map and status.",
        LAYOUT, "text");
  }
}
