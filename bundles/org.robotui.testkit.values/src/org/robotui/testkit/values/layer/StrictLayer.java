package org.robotui.testkit.values.layer;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.robotui.api.config.Schema;
import org.robotui.data.Data;
import org.robotui.ui.layer.DataLayer;
import org.robotui.ui.layer.LayerContext;
import org.robotui.ui.layer.LayerResult;
import org.robotui.ui.layer.LayerTick;
import org.robotui.ui.layer.LayerType;
import org.robotui.ui.scene.Bounds;
import org.robotui.ui.scene.Description;
import org.robotui.ui.scene.Painter;

/**
 * A layer that fails a test where a view would switch it off: views go on without a layer that throws, which would hide
 * it from tests.
 */
public final class StrictLayer implements DataLayer {
  private final DataLayer layer;

  private StrictLayer(DataLayer layer) {
    this.layer = layer;
  }

  /**
   * The same kinds, whose layers throw errors in place of exceptions.
   *
   * @param types the kinds
   * @return in the same order
   */
  public static List<LayerType> of(List<LayerType> types) {
    return types.stream().<LayerType>map(Kind::new).toList();
  }

  private record Kind(LayerType type) implements LayerType {
    @Override
    public String id() {
      return type.id();
    }

    @Override
    public String label() {
      return type.label();
    }

    @Override
    public String help() {
      return type.help();
    }

    @Override
    public List<Class<? extends Data>> accepts() {
      return type.accepts();
    }

    @Override
    public Set<Class<? extends Data>> needs() {
      return type.needs();
    }

    @Override
    public boolean automatic() {
      return type.automatic();
    }

    @Override
    public Set<Ground> grounds() {
      return type.grounds();
    }

    @Override
    public String data() {
      return type.data();
    }

    @Override
    public int level() {
      return type.level();
    }

    @Override
    public Schema schema() {
      return type.schema();
    }

    @Override
    public DataLayer create(LayerContext context) {
      return new StrictLayer(type.create(context));
    }
  }

  @Override
  public LayerResult update(LayerTick tick) {
    return strict(() -> layer.update(tick));
  }

  @Override
  public void paint(Painter painter) {
    strict(() -> {
      layer.paint(painter);
      return true;
    });
  }

  @Override
  public Optional<Bounds> bounds() {
    return strict(layer::bounds);
  }

  @Override
  public Optional<Description> describeAt(double x, double y, double tolerance) {
    return strict(() -> layer.describeAt(x, y, tolerance));
  }

  @Override
  public void dispose() {
    layer.dispose();
  }

  private static <R> R strict(Supplier<R> task) {
    try {
      return task.get();
    } catch (RuntimeException e) {
      throw new AssertionError("the layer would be switched off: " + e, e);
    }
  }
}
