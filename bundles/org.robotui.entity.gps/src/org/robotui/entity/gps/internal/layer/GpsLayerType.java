package org.robotui.entity.gps.internal.layer;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Shows receivers of satellite positions on a plane that touches the earth. */
@Component(service = LayerType.class)
public final class GpsLayerType implements LayerType {
  private static final double LONGEST_MINUTES = 100_000;

  private static final Schema SCHEMA = Schema.of(
      Inks.setting("one for each receiver"),
      Setting.of("trail_minutes", new ValueType.Num(0, LONGEST_MINUTES, "min"), 240.0, "How long the track is kept."),
      Setting.of("way_colors", new ValueType.Choice(List.of("auto", "receiver", "quality")), "auto",
          "Colour of the track: by quality of the fixes, by receiver, or auto: by quality where there is one receiver."));

  @Override
  public String id() {
    return "receiver";
  }

  @Override
  public String label() {
    return "Receiver";
  }

  @Override
  public String help() {
    return "Shows where a receiver of satellite positions is and has been, how good its fixes are, and how exact.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(GpsFix.class);
  }

  @Override
  public Set<Ground> grounds() {
    return Set.of(Ground.EARTH);
  }

  @Override
  public int level() {
    return 700;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new GpsLayer();
  }
}
