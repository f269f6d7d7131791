package org.robotui.entity.odometry.internal.display;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows where a robot was sent. */
@Component(service = DisplayType.class)
public final class GoalType implements DisplayType {
  private static final Schema SCHEMA = PoseSettings.single("#3ecf8e", 0.6);

  @Override
  public String id() {
    return "goal";
  }

  @Override
  public String label() {
    return "Navigation goal";
  }

  @Override
  public String help() {
    return "Shows the goal that a robot was sent to.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(NavigationGoal.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new PoseTrailDisplay<>(NavigationGoal.class, goal -> Doubles.EMPTY, context);
  }
}
