package org.robotui.entity.gridmap.internal.layer;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.navigation.GridMap;
import org.robotui.entity.gridmap.GridMapEntity;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerStatus;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.layer.NewestLayer;

/** Shows grid maps on maps. */
@Component(service = LayerType.class)
public final class GridMapLayerType implements LayerType {
  private static final double OVERLAY = 0.5;

  private static final Schema SCHEMA = Schema.of(
      Setting.optional("opacity", new ValueType.Num(0, 1, ""),
          "0 invisible to 1 opaque; without, the lowest map is opaque and others over it half."));

  @Override
  public String id() {
    return "map";
  }

  @Override
  public String label() {
    return "Map";
  }

  @Override
  public String help() {
    return "Shows an occupancy grid map.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(GridMap.class);
  }

  @Override
  public int level() {
    return 100;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    GridMapEntity entity = new GridMapEntity();
    return new NewestLayer<>(GridMap.class, NewestLayer.When.NOW, GridMap::frame, entity, (map, place, tick) -> {
      entity.opacity(opacity(tick));
      entity.prepare(map, place);
      return new LayerStatus.Shown(map.width() + " x " + map.height() + " cells");
    });
  }

  private static double opacity(LayerTick tick) {
    return tick.settings().has("opacity") ? tick.settings().number("opacity")
        : tick.entry().number() == 0 ? 1 : OVERLAY;
  }
}
