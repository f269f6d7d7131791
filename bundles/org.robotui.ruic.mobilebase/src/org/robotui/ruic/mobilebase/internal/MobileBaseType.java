package org.robotui.ruic.mobilebase.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.FixedRuicType;
import org.robotui.api.RuicType;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout.View;
import org.robotui.api.layout.Layout;

/**
 * The interface of a robot that drives: the map has most of the window, beside it what the robot sees, how it is driven
 * and how it is doing; below it what it measures and says. Behind the map lie the scene in space, its frames, the graph
 * of its programs, and what one asks a robot less often. The text view is for terminals and has no place in the
 * window's layout.
 */
@Component(service = RuicType.class)
public final class MobileBaseType extends FixedRuicType {
  private static final Tabs PLACES =
      new Tabs(List.of("map", "scene3d", "tftree", "graph", "topics", "parameters", "services", "actions"));
  private static final Tabs RECORDS = new Tabs(List.of("plot", "log", "diagnostics", "joints", "gps", "alerts"));
  private static final Tabs STATE = new Tabs(List.of("status", "connections"));

  private static final Layout MAIN = new Split(Direction.COLUMN, List.of(PLACES, RECORDS), List.of(66.0, 34.0));

  private static final Layout SIDE = new Split(Direction.COLUMN,
      List.of(new View("camera"), new View("teleop"), STATE), List.of(30.0, 33.0, 37.0));

  private static final Layout LAYOUT = new Split(Direction.ROW, List.of(MAIN, SIDE), List.of(64.0, 36.0));

  /** Made by the framework. */
  public MobileBaseType() {
    super("mobilebase", "Mobile base",
        "Map, camera, teleoperation and status of a robot that drives, with plots, log, diagnostics and all that it offers.",
        LAYOUT, "sound", "text");
  }
}
