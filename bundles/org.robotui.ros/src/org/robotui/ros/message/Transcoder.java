package org.robotui.ros.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Writes a message of one version of a type as one of another version, field by field, by name. */
final class Transcoder {

  private final ByteBuffer from;
  private final LayoutWalk walk;
  private final MessageWriter out;

  private Transcoder(ByteBuffer from) {
    this.from = from;
    this.walk = new LayoutWalk(from);
    this.out = new MessageWriter(from.limit() + 64);
  }

  /** Of a checked message; fails where a field of the same name is something else, or no field is common. */
  static ByteBuffer transcode(ByteBuffer from, Layout source, Layout target) throws MessageException {
    if (target.fields().stream().noneMatch(f -> source.field(f.name()).isPresent())) {
      throw new MessageException("this version of " + target.type() + " has no field in common with ours", "", 0);
    }
    Transcoder transcoder = new Transcoder(from);
    transcoder.message(source, target, 0);
    return ByteBuffer.wrap(transcoder.out.toByteArray()).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void message(Layout source, Layout target, int start) throws MessageException {
    for (Layout.Field wanted : target.fields()) {
      int at = start;
      boolean found = false;
      for (Layout.Field there : source.fields()) {
        if (there.name().equals(wanted.name())) {
          field(there, wanted, at);
          found = true;
          break;
        }
        at = walk.skip(there, at);
      }
      if (!found) {
        nothing(wanted);
      }
    }
  }

  private void field(Layout.Field there, Layout.Field wanted, int at) throws MessageException {
    if (there.primitive() != wanted.primitive() || there.type().arity() != wanted.type().arity()
        || there.type().length() != wanted.type().length()) {
      throw new MessageException("it is " + there.type() + " there and " + wanted.type() + " here", wanted.name(), at);
    }
    if (wanted.nested() == null || there.nested().equals(wanted.nested())) {
      copy(at, walk.skip(there, at));
    } else if (there.type().arity() == FieldType.Arity.ONE) {
      message(there.nested(), wanted.nested(), at);
    } else {
      messages(there, wanted, at);
    }
  }

  private void messages(Layout.Field there, Layout.Field wanted, int at) throws MessageException {
    int count = walk.count(there, at);
    int element = walk.firstElement(there, at);
    copy(at, element);
    for (int i = 0; i < count; i++) {
      message(there.nested(), wanted.nested(), element);
      element = walk.skip(there.nested(), element);
    }
  }

  private void copy(int start, int end) {
    out.bytes(from.slice(start, end - start));
  }

  /** The field as a new message has it: numbers zero, texts and lists empty. The fewest bytes, all zero, say just that. */
  private void nothing(Layout.Field wanted) {
    for (long i = 0; i < wanted.minSize(); i++) {
      out.u8(0);
    }
  }
}
