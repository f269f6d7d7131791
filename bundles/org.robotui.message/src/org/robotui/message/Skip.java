package org.robotui.message;

/** Passes over fields that a record leaves out. */
final class Skip {

  private Skip() {}

  static void field(Layout.Field field, FieldReader in) throws MessageException {
    int count = field.type().isArray() ? in.count(field.name(), LengthBounds.of(field.type()), field.element()) : 1;
    if (field.nested() == null) {
      in.skip(field.name(), field.primitive(), count);
      return;
    }
    try {
      for (int i = 0; i < count; i++) {
        for (Layout.Field each : field.nested().fields()) {
          field(each, in);
        }
      }
    } catch (MessageException e) {
      throw e.within(field.name());
    }
  }
}
