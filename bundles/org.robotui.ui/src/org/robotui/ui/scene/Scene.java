package org.robotui.ui.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * Layers in order. They may be added and removed on a worker; what a removed one holds of the display is released with
 * the next paint.
 */
public final class Scene {
  private static final double FADED = 0.35;

  private final Queue<Entity> removed = new ConcurrentLinkedQueue<>();
  private volatile List<Layer> layers = List.of();

  /** Without layers. */
  public Scene() {
    // Layers come with add.
  }

  /**
   * What lies on top of a point.
   *
   * @param layer the layer
   * @param description what of it
   */
  public record Hit(Layer layer, Description description) {}

  /**
   * Adds a layer.
   *
   * @param layer its id is not yet in the scene
   * @throws IllegalArgumentException where the id is taken
   */
  public synchronized void add(Layer layer) {
    if (find(layer.id()).isPresent()) {
      throw new IllegalArgumentException("the scene has a layer '" + layer.id() + "' already");
    }
    List<Layer> more = new ArrayList<>(layers);
    more.add(layer);
    more.sort(Comparator.comparingInt(Layer::order));
    layers = List.copyOf(more);
  }

  /**
   * Adds a layer, or puts another one in the place of the one with the same id, whose entity goes on being painted.
   *
   * @param layer with another order or caption
   */
  public synchronized void put(Layer layer) {
    List<Layer> more = new ArrayList<>(layers);
    more.removeIf(l -> l.id().equals(layer.id()));
    more.add(layer);
    more.sort(Comparator.comparingInt(Layer::order));
    layers = List.copyOf(more);
  }

  /**
   * Removes a layer; does nothing where there is none.
   *
   * @param id of the layer
   */
  public synchronized void remove(String id) {
    find(id).ifPresent(layer -> {
      layers = layers.stream().filter(l -> l != layer).toList();
      removed.add(layer.entity());
    });
  }

  /**
   * All layers.
   *
   * @return lowest first
   */
  public List<Layer> layers() {
    return layers;
  }

  /**
   * Finds a layer.
   *
   * @param id its id
   * @return the layer, or none
   */
  public Optional<Layer> find(String id) {
    return layers.stream().filter(l -> l.id().equals(id)).findFirst();
  }

  /**
   * Paints the visible layers. Display thread.
   *
   * @param painter where
   */
  public void paint(Painter painter) {
    release();
    layers.forEach(layer -> paint(layer, painter));
  }

  /**
   * Paints a layer where it is visible; one that has been removed has given back what it held of the display, and would
   * take it again. Display thread.
   */
  void paint(Layer layer, Painter painter) {
    if (layer.visible() && layers.contains(layer)) {
      painter.fade(layer.faded() ? FADED : 1);
      layer.entity().paint(painter);
      painter.fade(1);
    }
  }

  /**
   * How far the visible layers reach.
   *
   * @return the bounds, or none where there is nothing to see
   */
  public Optional<Bounds> bounds() {
    return layers.stream()
        .filter(Layer::visible)
        .flatMap(l -> l.entity().bounds().stream())
        .reduce(Bounds::union);
  }

  /**
   * What lies at a point, topmost first.
   *
   * @param x metres
   * @param y metres
   * @param tolerance how far away still counts, metres
   * @return the visible layers that have something there
   */
  public List<Hit> at(double x, double y, double tolerance) {
    return layers.reversed().stream()
        .filter(Layer::visible)
        .flatMap(l -> l.entity().describeAt(x, y, tolerance).map(d -> new Hit(l, d)).stream())
        .toList();
  }

  /** Releases what all entities hold of the display. Display thread. */
  public void dispose() {
    release();
    layers.forEach(l -> l.entity().dispose());
  }

  /** Releases what removed layers hold of the display. Display thread. */
  void release() {
    for (Entity entity = removed.poll(); entity != null; entity = removed.poll()) {
      entity.dispose();
    }
  }
}
