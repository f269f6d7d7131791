package org.robotui.player.layout;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.MessageType;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** All known interfaces. Immutable; any thread may use it. */
public final class Layouts {

  private static final String FOLDER = "interfaces/";
  private static final String COMMON = "any";

  private final Map<String, InterfaceLayout> byName;
  private final Map<Integer, InterfaceLayout> byCode = new LinkedHashMap<>();
  private final Map<Object, Codec<?>> codecs = new ConcurrentHashMap<>();

  private Layouts(Map<String, InterfaceLayout> byName) {
    this.byName = byName;
    byName.values().forEach(each -> byCode.put(each.code(), each));
  }

  /**
   * Player's own interfaces.
   *
   * @return read from this bundle
   */
  public static Layouts standard() {
    Map<String, InterfaceLayout> read = new LinkedHashMap<>();
    Map<String, StructLayout> common = Map.of();
    for (String name : text(FOLDER + "index").lines().filter(line -> !line.startsWith("#")).toList()) {
      InterfaceLayout layout = LayoutParser.parse(name, text(FOLDER + name + ".layout"), common);
      common = layout.name().equals(COMMON) ? layout.structs() : common;
      read.put(layout.name(), layout);
    }
    return new Layouts(read);
  }

  /**
   * These interfaces and one more, such as that of a plugin. One of the same name or code is replaced.
   *
   * @param file the name of the description, for errors
   * @param text the description
   * @return the larger set
   * @throws LayoutException if the description is not understood
   */
  public Layouts with(String file, String text) {
    InterfaceLayout layout = LayoutParser.parse(file, text, byName.get(COMMON).structs());
    Map<String, InterfaceLayout> more = new LinkedHashMap<>(byName);
    more.values().removeIf(each -> each.code() == layout.code());
    more.put(layout.name(), layout);
    return new Layouts(more);
  }

  /**
   * Every interface.
   *
   * @return in no order
   */
  public Collection<InterfaceLayout> all() {
    return List.copyOf(byName.values());
  }

  /**
   * Finds an interface.
   *
   * @param code its number
   * @return empty if it is not known
   */
  public Optional<InterfaceLayout> byCode(int code) {
    return Optional.ofNullable(byCode.get(code));
  }

  /**
   * Finds an interface.
   *
   * @param name such as {@code position2d}
   * @return empty if it is not known
   */
  public Optional<InterfaceLayout> byName(String name) {
    return Optional.ofNullable(byName.get(name));
  }

  /**
   * A device as people write it.
   *
   * @param device its address
   * @return such as {@code position2d:0}
   */
  public String nameOf(DeviceAddress device) {
    return byCode(device.interfaceCode()).map(InterfaceLayout::name).orElse("interface" + device.interfaceCode()) + ":"
        + device.index();
  }

  /**
   * Finds the description of a message.
   *
   * @param message the message
   * @return empty if it is not known
   */
  public Optional<MessageLayout> of(PlayerMessage message) {
    return byCode(message.device().interfaceCode()).flatMap(known -> known.message(message.type(), message.subtype()))
        .or(() -> byName(COMMON).flatMap(any -> any.message(message.type(), message.subtype())));
  }

  /**
   * Reads a message's body as named values. The body of a message that is not known, or of a refusal that is like
   * neither question nor answer, becomes one field {@code bytes}.
   *
   * @param message the message
   * @return its body; a record without fields if it has none
   * @throws PlayerException if the message is known and its body is not valid; names device, message and field
   */
  public PlayerRecord decode(PlayerMessage message) throws PlayerException {
    return new MessageDecoder(this, message).decode();
  }

  /**
   * Writes a record as a message's body.
   *
   * @param record the record
   * @return the bytes, read only
   */
  public ByteBuffer encode(PlayerRecord record) {
    return Codec.browsing(record.layout().name(), record.layout()).encode(record);
  }

  @SuppressWarnings("unchecked")
  Codec<PlayerRecord> browsing(StructLayout struct) {
    return (Codec<PlayerRecord>) codecs.computeIfAbsent(struct, none -> Codec.browsing(struct.name(), struct));
  }

  /**
   * The description of a kind of message.
   *
   * @param kind the kind
   * @return the interface's message
   * @throws LayoutException if it is not known
   */
  public MessageLayout message(Kind kind) {
    return byName(kind.on()).flatMap(known -> known.message(kind.wireType(), kind.message()))
        .orElseThrow(() -> new LayoutException(
            "there is no " + kind.wireType() + " '" + kind.message() + "' of '" + kind.on() + "'"));
  }

  /**
   * The codec of a measurement.
   *
   * @param kind which
   * @param <T> its record
   * @return the codec
   * @throws LayoutException if message or record do not fit the layouts
   */
  public <T> Codec<T> codec(Kind.Data<T> kind) {
    return typed(kind, kind, message(kind).payload(), kind.type());
  }

  /**
   * The codec of a command.
   *
   * @param kind which
   * @param <T> its record
   * @return the codec
   * @throws LayoutException if message or record do not fit the layouts
   */
  public <T> Codec<T> codec(Kind.Command<T> kind) {
    return typed(kind, kind, message(kind).payload(), kind.type());
  }

  /**
   * The codec of a request's question.
   *
   * @param kind which
   * @param <Q> the question's record
   * @return the codec
   * @throws LayoutException if message or record do not fit the layouts
   */
  public <Q> Codec<Q> question(Kind.Request<Q, ?> kind) {
    return typed(kind, kind, message(kind).payload(), kind.asked());
  }

  /**
   * The codec of a request's answer.
   *
   * @param kind which
   * @param <A> the answer's record
   * @return the codec
   * @throws LayoutException if message or record do not fit the layouts
   */
  public <A> Codec<A> answer(Kind.Request<?, A> kind) {
    return typed(List.of(kind), kind, message(kind).answer(), kind.answer());
  }

  @SuppressWarnings("unchecked")
  private <T> Codec<T> typed(Object key, Kind kind, Optional<StructLayout> struct, Class<T> type) {
    return (Codec<T>) codecs.computeIfAbsent(key,
        none -> Codec.of(kind.on() + " " + name(kind.wireType()) + " " + kind.message(), struct, type));
  }

  static String name(MessageType type) {
    return type.name().toLowerCase(Locale.ROOT);
  }

  private static String text(String resource) {
    try (InputStream in = Layouts.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new LayoutException("the resource " + resource + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
