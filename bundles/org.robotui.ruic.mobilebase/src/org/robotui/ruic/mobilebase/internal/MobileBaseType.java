package org.robotui.ruic.mobilebase.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.View;

/**
 * The interface of a robot that drives: the map has most of the window, beside it what the robot sees, how it is driven and
 * how it is doing. The text view is for terminals and has no place in the window's layout.
 */
@Component(service = RuicType.class)
public final class MobileBaseType implements RuicType {
  private static final List<UicSpec> VIEWS = List.of(
      new UicSpec("map", "map"),
      new UicSpec("camera", "camera"),
      new UicSpec("teleop", "teleop"),
      new UicSpec("status", "status"),
      new UicSpec("text", "text"));

  private static final Layout COLUMN = new Split(Direction.COLUMN,
      List.of(new View("camera"), new View("teleop"), new View("status")), List.of(30.0, 33.0, 37.0));

  private static final Layout LAYOUT =
      new Split(Direction.ROW, List.of(new View("map"), COLUMN), List.of(64.0, 36.0));

  @Override
  public String id() {
    return "mobilebase";
  }

  @Override
  public String label() {
    return "Mobile base";
  }

  @Override
  public String help() {
    return "Map, camera, teleoperation and status of a robot that drives.";
  }

  @Override
  public Schema schema() {
    return Schema.EMPTY;
  }

  @Override
  public List<UicSpec> uics(Settings settings) {
    return VIEWS;
  }

  @Override
  public Layout layout(Settings settings) {
    return LAYOUT;
  }
}
