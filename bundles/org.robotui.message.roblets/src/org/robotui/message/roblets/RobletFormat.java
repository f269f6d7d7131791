package org.robotui.message.roblets;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.RobletMessages;
import org.robotui.message.payload.PayloadFormat;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.tree.BodyXml;
import org.robotui.roblets.tree.BodyXmlException;
import org.robotui.roblets.wire.BodyDatagram;

/**
 * Messages of roblets in recordings: datagrams in XML, which say themselves of what they consist. What they are is said
 * by their form, where the recording has it.
 *
 * @param type what they are, or where they came from
 * @param shape their fields, as far as the roblet has announced them
 */
public record RobletFormat(String type, Optional<RecordShape> shape) implements PayloadFormat {
  /** How messages are named in recordings. */
  public static final String ENCODING = "xml";

  /** How forms are named in recordings. */
  public static final String FORM_ENCODING = "roblet";

  private static final String DIRECTION = "output";

  /**
   * The type of what a roblet says.
   *
   * @param roblet its name
   * @param form what it says
   * @return one that is known all over, where its form names one, else one of its own
   */
  public static String type(String roblet, BodyForm form) {
    return RobletMessages.isKnown(form.as()) ? RobletMessages.NAMES + form.as() : roblet + "." + form.name();
  }

  /**
   * A form as recordings have it.
   *
   * @param form the form
   * @return XML in UTF-8
   */
  public static byte[] definition(BodyForm form) {
    return BodyXml.bytes(form.element(DIRECTION));
  }

  /**
   * What a recording says of messages.
   *
   * @param type of them; may be empty
   * @param definition their form; empty or wrong where the recording does not have it
   * @return reads them
   */
  public static RobletFormat of(String type, String definition) {
    String name = type.isEmpty() ? ENCODING : type;
    try {
      BodyForm form = BodyForm.of(new BodyXml().read(definition.getBytes(StandardCharsets.UTF_8)));
      return new RobletFormat(name,
          Optional.of(ElementRecord.shape(name, form)).filter(known -> !known.fields().isEmpty()));
    } catch (BodyXmlException | IllegalArgumentException e) {
      return new RobletFormat(name, Optional.empty());
    }
  }

  @Override
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public <M> Reading<M> reading(MessageForm<M> form) {
    if (!(form instanceof MessageForm.ByFields)) {
      throw new IllegalArgumentException("messages of roblets have no definition of ROS");
    }
    return payload -> (M) record(payload);
  }

  private DynamicRecord record(ByteBuffer payload) {
    byte[] bytes = new byte[payload.remaining()];
    payload.duplicate().get(bytes);
    try {
      BodyElement said = BodyDatagram.of(bytes, new BodyXml()).body()
          .orElseThrow(() -> new IllegalArgumentException("a datagram of a roblet that says nothing"));
      return ElementRecord.of(type, said);
    } catch (BodyXmlException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  @Override
  public ByteBuffer write(Map<String, Object> fields) {
    throw new IllegalArgumentException("messages of roblets in recordings are read alone");
  }
}
