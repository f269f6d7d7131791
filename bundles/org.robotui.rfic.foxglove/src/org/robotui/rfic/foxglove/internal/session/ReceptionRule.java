package org.robotui.rfic.foxglove.internal.session;

import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.robotui.message.data.Adapters;
import org.robotui.message.data.FoxgloveTransforms;
import org.robotui.message.data.MessageForm;
import org.robotui.message.ros.tf2_msgs.TFMessage;
import org.robotui.message.payload.PayloadFormat.Reading;
import org.robotui.rfic.foxglove.internal.session.ChannelTable.Offered;

/**
 * Which channels are meant by a topic, and how they are read. Transforms come by any topic in the schemas of Foxglove.
 *
 * @param topic its name
 * @param type the type of its messages
 * @param form what they are read as
 * @param <M> the Java value of a message
 */
record ReceptionRule<M>(String topic, String type, MessageForm<M> form) {
  private static final MessageForm<TFMessage> TRANSFORMS = new MessageForm.Bound<>(TFMessage.class, false);
  private static final String MOVING = "/tf";
  private static final String FIXED = "/tf_static";
  private static final Set<String> TYPES = Set.of("tf2_msgs/TFMessage", "tf/tfMessage");

  List<Offered> channels(ChannelTable table) {
    Stream<Offered> own = table.of(topic).stream();
    if (!form.equals(TRANSFORMS)) {
      return own.filter(each -> each.format().type().equals(type)).toList();
    }
    Stream<Offered> elsewhere = topic.equals(MOVING)
        ? table.all().filter(each -> !Set.of(MOVING, FIXED).contains(ChannelTable.global(each.channel().topic())))
        : Stream.of();
    return Stream.concat(own.filter(each -> TYPES.contains(each.format().type()) || isForeign(each)),
        elsewhere.filter(ReceptionRule::isForeign)).toList();
  }

  private static boolean isForeign(Offered offered) {
    return FoxgloveTransforms.is(offered.format().type());
  }

  @SuppressWarnings("unchecked") // the form is that of transforms
  Reading<M> reading(Offered offered) {
    if (form.equals(TRANSFORMS) && isForeign(offered)) {
      return payload -> (M) FoxgloveTransforms.message(offered.format().read(payload));
    }
    return offered.format().reading(form);
  }

  int mostWaiting() {
    return new Adapters().mostWaiting(type, form);
  }
}
