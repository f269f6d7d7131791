package org.robotui.uic.team.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/** Lists the robots of a team, and commands one, some, or all. */
@Component(service = UicType.class)
public final class TeamType implements UicType {
  static final String LEFT_OUT = "left_out";
  static final String TASK = "task";

  private static final double RATE_HZ = 5;
  private static final Schema SCHEMA = Schema.of(
      Setting.of(LEFT_OUT, new ValueType.ListOf(new ValueType.Text()), List.of(),
          "Names under 'rfics' that are no robots, such as a map server."),
      Setting.of(TASK, new ValueType.Text(), "move_base/status",
          "The end of the names of streams that tell what robots do."));

  private static final Descriptor DESCRIPTOR = new Descriptor("team", "Team",
      "How every robot of a team is doing; stops, releases and opens one, some, or all.", SCHEMA, TeamPorts.ALL);

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new TeamUic(context, settings.list(LEFT_OUT).stream().map(Object::toString).toList(), settings.text(TASK));
  }
}
