package org.robotui.ruic.team.internal;

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
 * The interface of a group or a swarm, whatever its robots run: all of them on one map, and in a table that commands
 * one, some, or all. What one robot has in detail is seen in an interface of its own, which opens from the table.
 */
@Component(service = RuicType.class)
public final class TeamType extends FixedRuicType {
  private static final Tabs PLACES = new Tabs(List.of("map", "scene3d"));
  private static final Tabs RECORDS = new Tabs(List.of("plot", "log", "alerts", "connections"));
  private static final Layout SIDE =
      new Split(Direction.COLUMN, List.of(new View("team"), RECORDS), List.of(68.0, 32.0));
  private static final Layout LAYOUT = new Split(Direction.ROW, List.of(PLACES, SIDE), List.of(52.0, 48.0));

  /** Made by the framework. */
  public TeamType() {
    super("team", "Team",
        "All robots of a group or a swarm on one map and in one table, to command one, some, or all of them.",
        LAYOUT, "sound", "text");
  }
}
