package org.robotui.player.layout;

/** Structures as records that can be browsed. */
record BrowsableShape(StructLayout struct) implements Shape {

  @Override
  public Object build(Object[] values) {
    return new PlayerRecord(struct, values);
  }

  @Override
  public Object[] parts(Object built) {
    return ((PlayerRecord) built).values();
  }

  @Override
  public Shape nested(int index, FieldLayout field) {
    return new BrowsableShape(field.struct().orElseThrow());
  }
}
