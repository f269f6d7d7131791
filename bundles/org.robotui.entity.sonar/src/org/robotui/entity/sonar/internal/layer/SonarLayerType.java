package org.robotui.entity.sonar.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.data.sensor.RangeReadings;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Shows sonars on maps. */
@Component(service = LayerType.class)
public final class SonarLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(Inks.setting("that of sonars"));

  @Override
  public String id() {
    return "sonar";
  }

  @Override
  public String label() {
    return "Sonar";
  }

  @Override
  public String help() {
    return "Shows the cones of sonars and infrared sensors.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(RangeReadings.class);
  }

  @Override
  public int level() {
    return 200;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new SonarLayer();
  }
}
