package org.robotui.entity.odometry.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.Odometry;
import org.robotui.entity.odometry.OdometryEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;
import org.robotui.ui.scene.Ink;

/** Shows trails on maps. */
@Component(service = LayerType.class)
public final class OdometryLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(
      Inks.setting("one for each trail"),
      Setting.of("length", new ValueType.Num(0, 100_000, "m"), 30.0, "How much of the trail is shown."),
      Setting.of("uncertainty", new ValueType.Flag(), false,
          "Whether two standard deviations around the place are shown."));

  @Override
  public String id() {
    return "trail";
  }

  @Override
  public String label() {
    return "Trail";
  }

  @Override
  public String help() {
    return "Shows where a robot has been by its odometry.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(Odometry.class);
  }

  @Override
  public String data() {
    return "odometry";
  }

  @Override
  public int level() {
    return 400;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    OdometryEntity entity = new OdometryEntity(0);
    return new NewestLayer<>(Odometry.class, NewestLayer.When.NOW, Odometry::frame, entity, (odometry, place, tick) -> {
      entity.ink(tick.ink() instanceof Ink.Usual ? new Ink.Trace(tick.entry().number()) : tick.ink());
      entity.showUncertainty(tick.settings().flag("uncertainty"));
      entity.prepare(odometry, place, tick.settings().number("length"));
      return new LayerStatus.Shown("");
    }, (odometry, tick) -> "", entity::clear);
  }
}
