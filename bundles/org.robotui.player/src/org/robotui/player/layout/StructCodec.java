package org.robotui.player.layout;

import java.util.List;
import java.util.stream.IntStream;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.XdrReader;
import org.robotui.player.wire.XdrWriter;

/** Between a structure's bytes and its Java object, whatever its shape. */
final class StructCodec {

  private final StructLayout struct;
  private final Shape shape;
  private final List<FieldCodec> fields;

  StructCodec(StructLayout struct, Shape shape) {
    this.struct = struct;
    this.shape = shape;
    this.fields = IntStream.range(0, struct.fields().size())
        .mapToObj(i -> FieldCodec.of(struct.fields().get(i), i, shape)).toList();
  }

  int minBytes() {
    return fields.stream().mapToInt(FieldCodec::minBytes).sum();
  }

  Object read(XdrReader in) throws PlayerException {
    Object[] values = new Object[fields.size()];
    int at = 0;
    int earlier = 0;
    for (FieldLayout field : struct.wire()) {
      try {
        if (field.arity() == FieldLayout.Arity.COUNT) {
          earlier = in.count(1);
        } else {
          values[at] = fields.get(at++).read(in, earlier);
        }
      } catch (PlayerException e) {
        throw e.within(field.name());
      }
    }
    return shape.build(values);
  }

  void write(Object built, XdrWriter out) {
    Object[] values = shape.parts(built);
    int at = 0;
    for (FieldLayout field : struct.wire()) {
      if (field.arity() == FieldLayout.Arity.COUNT) {
        out.i32(FieldCodec.length(values[indexOf(field.name())]));
      } else {
        fields.get(at).write(values[at], out);
        at++;
      }
    }
  }

  private int indexOf(String name) {
    return IntStream.range(0, struct.fields().size()).filter(i -> struct.fields().get(i).name().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalStateException(struct.name() + " counts '" + name + "', which it does not have"));
  }
}
