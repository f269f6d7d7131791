package org.robotui.message;

/** Passes over fields that a record leaves out. */
final class Skip {

  private Skip() {}

  static void field(Layout.Field field, FieldReader in) throws MessageException {
    int count = switch (field.type().arity()) {
      case ONE -> 1;
      case FIXED -> field.type().length();
      case VARIABLE -> in.count(field.name(), field.element());
    };
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
