package org.robotui.message.payload;

import java.util.Set;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FoxgloveTransforms;
import org.robotui.message.data.MessageForm;
import org.robotui.message.payload.PayloadFormat.Reading;
import org.robotui.message.ros.tf2_msgs.TFMessage;

/**
 * Which channels are meant by a topic, and how they are read. Transforms come by any topic in the schemas of Foxglove.
 *
 * @param topic its name
 * @param type the type of its messages
 * @param form what they are read as
 * @param <M> the Java value of a message
 */
public record ReceptionRule<M>(String topic, String type, MessageForm<M> form) {
  private static final MessageForm<TFMessage> TRANSFORMS = new MessageForm.Bound<>(TFMessage.class, false);
  private static final String MOVING = "/tf";
  private static final String FIXED = "/tf_static";
  private static final Set<String> TYPES = Set.of("tf2_msgs/TFMessage", "tf/tfMessage");

  /**
   * The name of a topic as robot interfaces have it.
   *
   * @param topic the name that a server or a recording has
   * @return begins with a slash
   */
  public static String global(String topic) {
    return topic.startsWith("/") ? topic : "/" + topic;
  }

  /**
   * Whether a channel is meant.
   *
   * @param name the topic of the channel, begins with a slash
   * @param format reads its messages
   * @return true where it carries messages of this topic
   */
  public boolean takes(String name, PayloadFormat format) {
    boolean own = name.equals(topic);
    if (!form.equals(TRANSFORMS)) {
      return own && format.type().equals(type);
    }
    boolean elsewhere = topic.equals(MOVING) && !name.equals(FIXED);
    return own && TYPES.contains(format.type()) || (own || elsewhere) && FoxgloveTransforms.is(format.type());
  }

  /**
   * Reads what such a channel brings.
   *
   * @param format reads its messages
   * @return reads them as this topic's
   * @throws IllegalArgumentException where they cannot be read so
   */
  @SuppressWarnings("unchecked") // the form is that of transforms
  public Reading<M> reading(PayloadFormat format) {
    if (form.equals(TRANSFORMS) && FoxgloveTransforms.is(format.type())) {
      return payload -> (M) FoxgloveTransforms.message(format.read(payload));
    }
    return format.reading(form);
  }

  /**
   * How many messages are worth keeping until they are taken.
   *
   * @return 1 where only the newest counts
   */
  public int mostWaiting() {
    return new Adapters().mostWaiting(type, form);
  }
}
