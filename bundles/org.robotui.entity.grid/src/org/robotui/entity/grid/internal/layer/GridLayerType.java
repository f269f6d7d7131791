package org.robotui.entity.grid.internal.layer;

import java.util.List;
import java.util.Set;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.Inks;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerType;

/** Shows a metric grid on maps. */
@Component(service = LayerType.class)
public final class GridLayerType implements LayerType {
  private static final Schema SCHEMA = Schema.of(Inks.setting("a quiet one"));

  @Override
  public String id() {
    return "grid";
  }

  @Override
  public String label() {
    return "Grid";
  }

  @Override
  public String help() {
    return "Shows a metric grid, by which distances are seen.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of();
  }

  @Override
  public boolean automatic() {
    return true;
  }

  @Override
  public Set<Ground> grounds() {
    return Set.of(Ground.FRAME, Ground.EARTH);
  }

  @Override
  public int level() {
    return 0;
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public DataLayer create(LayerContext context) {
    return new GridLayer();
  }
}
