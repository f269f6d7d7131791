package org.robotui.player.layout;

/** How a structure is kept in Java: as a record that can be browsed, or as a Java record of its own. */
interface Shape {

  /** Makes the object from the values of its fields, in their order. */
  Object build(Object[] values);

  /** The values of an object's fields, in their order. */
  Object[] parts(Object built);

  /** How a field that is a structure is kept. */
  Shape nested(int index, FieldLayout field);
}
