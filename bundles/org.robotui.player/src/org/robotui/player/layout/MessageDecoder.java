package org.robotui.player.layout;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/**
 * Finds out what a body can be. Drivers refuse with an empty body, or with the question or the answer they were asked
 * for.
 */
final class MessageDecoder {

  static final StructLayout NOTHING = new StructLayout("empty", "no body", List.of());

  private final Layouts layouts;
  private final PlayerMessage message;

  MessageDecoder(Layouts layouts, PlayerMessage message) {
    this.layouts = layouts;
    this.message = message;
  }

  PlayerRecord decode() throws PlayerException {
    Optional<MessageLayout> layout = layouts.of(message);
    if (layout.isEmpty()) {
      return raw();
    }
    return switch (message.type()) {
      case ACK -> acknowledged(layout.get());
      case NACK -> firstThatFits(
          Stream.of(Optional.<StructLayout>empty(), layout.get().payload(), layout.get().answer()).toList());
      default -> as(layout.get().payload());
    };
  }

  /** Where nothing is answered some drivers return the question. */
  private PlayerRecord acknowledged(MessageLayout layout) throws PlayerException {
    return layout.answer().isPresent() ? as(layout.answer())
        : firstThatFits(List.of(Optional.empty(), layout.payload()));
  }

  private PlayerRecord firstThatFits(List<Optional<StructLayout>> candidates) throws PlayerException {
    for (Optional<StructLayout> candidate : candidates) {
      try {
        return as(candidate);
      } catch (PlayerException e) {
        // the next one may fit; what none fits is shown as bytes
        continue;
      }
    }
    return raw();
  }

  private PlayerRecord as(Optional<StructLayout> struct) throws PlayerException {
    StructLayout wanted = struct.orElse(NOTHING);
    try {
      return layouts.browsing(wanted).decode(message.payload());
    } catch (PlayerException e) {
      throw e.within(layouts.nameOf(message.device()) + " " + Layouts.name(message.type()) + " " + message.subtype());
    }
  }

  private PlayerRecord raw() throws PlayerException {
    ByteBuffer payload = message.payload();
    if (!payload.hasRemaining()) {
      return as(Optional.empty());
    }
    byte[] bytes = new byte[payload.remaining()];
    payload.get(bytes);
    FieldLayout field =
        new FieldLayout("bytes", Primitive.U8, FieldLayout.Arity.FIXED, bytes.length, "", "as they came");
    return new PlayerRecord(new StructLayout("unknown", "a message that is not known", List.of(field)),
        new Object[]{bytes});
  }
}
