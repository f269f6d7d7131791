package org.robotui.message.lcm;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.lcm.type.LcmType;
import org.robotui.lcm.type.RecordException;
import org.robotui.lcm.type.TypeException;
import org.robotui.lcm.type.TypeLibrary;
import org.robotui.lcm.type.TypeParser;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat;

/**
 * Messages of LCM in recordings, by the declaration that the recording has of them. Those of a type that nobody
 * declares are records of their bytes.
 *
 * @param type the name of their type, or what is said of one that is not known
 * @param known the type, where it is declared
 * @param types all that its declaration has
 * @param reason why messages are bytes alone; empty where they are not
 */
public record LcmFormat(String type, Optional<LcmType> known, TypeLibrary types, String reason)
    implements PayloadFormat {
  /** How messages and declarations are named in recordings. */
  public static final String ENCODING = "lcm";

  /**
   * What a recording says of messages.
   *
   * @param name of their type; empty where it is not known
   * @param declaration of it and of those that it holds, as a {@code .lcm} file; may be empty
   * @param fingerprint that they begin with, in words; may be empty
   * @return reads them
   */
  public static LcmFormat of(String name, String declaration, String fingerprint) {
    try {
      TypeLibrary types = TypeLibrary.of(TypeParser.parse(name, declaration), List.of());
      Optional<LcmType> type = types.type(name);
      return new LcmFormat(name.isEmpty() ? unknown(fingerprint) : name, type, types,
          type.isPresent() ? "" : remedy(fingerprint));
    } catch (TypeException e) {
      return new LcmFormat(name, Optional.empty(), TypeLibrary.of(List.of(), List.of()), e.getMessage());
    }
  }

  private static String unknown(String fingerprint) {
    return fingerprint.isEmpty() ? "bytes" : "unknown " + fingerprint;
  }

  private static String remedy(String fingerprint) {
    return fingerprint.isEmpty() ? "its type is not known, as its messages have no fingerprint of one"
        : "no type is known that has the fingerprint " + fingerprint
            + "; write after types: where the .lcm files are that its sender was built with";
  }

  @Override
  public Optional<String> obstacle() {
    return Optional.of(reason).filter(text -> !text.isEmpty());
  }

  @Override
  public Optional<RecordShape> shape() {
    return known.map(found -> TypeShapes.of(found, types));
  }

  @Override
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public <M> Reading<M> reading(MessageForm<M> form) {
    if (!(form instanceof MessageForm.ByFields)) {
      throw new IllegalArgumentException("messages of LCM have no definition of ROS");
    }
    return payload -> (M) record(payload);
  }

  private DynamicRecord record(ByteBuffer payload) {
    if (known.isEmpty()) {
      return UnknownMessage.of(payload, reason);
    }
    try {
      return new RecordView(known.get().decode(payload));
    } catch (RecordException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    throw new IllegalArgumentException("messages of LCM in recordings are read alone");
  }
}
