package org.robotui.ui.scene;

/**
 * An entity in a scene, with what a user or its data's age decides about it. Safe for all threads.
 */
public final class Layer {
  private final String id;
  private final int order;
  private final String caption;
  private final Entity entity;
  private volatile boolean visible = true;
  private volatile boolean faded;

  /**
   * A visible layer.
   *
   * @param id unique within the scene
   * @param order layers with larger numbers are painted over those with smaller ones
   * @param caption what users read, for example {@code scan - base.scan}
   * @param entity what is painted
   */
  public Layer(String id, int order, String caption, Entity entity) {
    this.id = id;
    this.order = order;
    this.caption = caption;
    this.entity = entity;
  }

  /**
   * The id.
   *
   * @return unique within the scene
   */
  public String id() {
    return id;
  }

  /**
   * The place in the stack.
   *
   * @return larger is above
   */
  public int order() {
    return order;
  }

  /**
   * What users read.
   *
   * @return the caption
   */
  public String caption() {
    return caption;
  }

  /**
   * What is painted.
   *
   * @return the entity
   */
  public Entity entity() {
    return entity;
  }

  /**
   * Whether it is painted.
   *
   * @return true at the beginning
   */
  public boolean visible() {
    return visible;
  }

  /**
   * Shows or hides it.
   *
   * @param shown whether it is painted
   */
  public void show(boolean shown) {
    visible = shown;
  }

  /**
   * Whether it is painted faintly, because it is stale.
   *
   * @return false at the beginning
   */
  public boolean faded() {
    return faded;
  }

  /**
   * Fades it, or not.
   *
   * @param stale whether its data is old
   */
  public void fade(boolean stale) {
    faded = stale;
  }
}
