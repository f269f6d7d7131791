package org.robotui.player.layout;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.XdrReader;
import org.robotui.player.wire.XdrWriter;

/**
 * Between the bodies of one message and their Java objects. Immutable.
 *
 * @param <T> the objects: {@link PlayerRecord}, a Java record, or {@link Empty} for messages without a body
 */
public final class Codec<T> {

  private final String name;
  private final Class<T> type;
  private final Optional<StructCodec> struct;

  private Codec(String name, Class<T> type, Optional<StructCodec> struct) {
    this.name = name;
    this.type = type;
    this.struct = struct;
  }

  static Codec<PlayerRecord> browsing(String name, StructLayout struct) {
    return new Codec<>(name, PlayerRecord.class, Optional.of(new StructCodec(struct, new BrowsableShape(struct))));
  }

  static <T> Codec<T> of(String name, Optional<StructLayout> struct, Class<T> type) {
    if (struct.isEmpty() != (type == Empty.class)) {
      throw new LayoutException(
          name + " is " + (struct.isEmpty() ? "" : "not ") + "empty, but its Java type is " + type.getName());
    }
    return new Codec<>(name, type, struct.map(layout -> new StructCodec(layout, RecordShape.of(layout, type))));
  }

  /**
   * Reads a body.
   *
   * @param payload the whole body
   * @return its object
   * @throws PlayerException if it is no such body; says which message and field, and why
   */
  public T decode(ByteBuffer payload) throws PlayerException {
    XdrReader in = new XdrReader(payload);
    try {
      Object built = struct.isPresent() ? struct.get().read(in) : new Empty();
      in.end();
      return type.cast(built);
    } catch (PlayerException e) {
      throw e.within(name);
    }
  }

  /**
   * Writes a body.
   *
   * @param value its object
   * @return the bytes, read only
   */
  public ByteBuffer encode(T value) {
    XdrWriter out = new XdrWriter();
    struct.ifPresent(codec -> codec.write(value, out));
    return out.buffer();
  }
}
