package org.robotui.entity.reach.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.Odometry;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;

/**
 * The kind that maps offer to users: what it is called, what can be set, which data it draws, and how an instance is
 * made.
 */
@Component(service = LayerType.class)
public final class ReachType implements LayerType {

  static final String SECONDS = "seconds";

  private static final int BELOW_ROBOTS = 600;

  private static final Schema SCHEMA = Schema.of(
      Inks.setting("that of plans"),
      Setting.of(SECONDS, new ValueType.Num(0.1, 60, "s"), 2.0, "How far ahead is looked."));

  @Override
  public String id() {
    return "reach";
  }

  @Override
  public String label() {
    return "Reach";
  }

  @Override
  public String help() {
    return "Shows where a robot will go if it keeps its speed.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Odometry.class);
  }

  @Override
  public int level() {
    return BELOW_ROBOTS;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  /**
   * A value is prepared anew where it is another one, where its frame has moved, and where the settings have changed.
   */
  @Override
  public DataLayer create(LayerContext context) {
    ReachEntity entity = new ReachEntity();
    return new NewestLayer<>(Odometry.class, NewestLayer.When.NOW, Odometry::childFrame, entity,
        (odometry, place, tick) -> {
          entity.prepare(ReachTurn.of(odometry, place, tick.settings().number(SECONDS)), tick.ink());
          return new LayerStatus.Shown("");
        });
  }
}
