package org.robotui.entity.odometry.internal.layer;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.navigation.Odometry;
import org.robotui.entity.odometry.internal.colored.ColorBy;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Shows trails on maps. */
@Component(service = LayerType.class)
public final class OdometryLayerType implements LayerType {
  private static final Schema SCHEMA = ColorBy.with(
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
  public Set<SourceId> also(Settings settings) {
    return ColorBy.source(settings);
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new TrailLayer(context);
  }
}
