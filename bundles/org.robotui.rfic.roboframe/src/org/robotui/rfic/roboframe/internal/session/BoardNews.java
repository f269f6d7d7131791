package org.robotui.rfic.roboframe.internal.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.roboframe.link.BrokerLink;
import org.robotui.roboframe.link.BrokerListener;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/** Takes what an application says, from before the session is made that looks at it. */
final class BoardNews implements BrokerListener {
  private final AtomicReference<Optional<List<BoardKey>>> keys = new AtomicReference<>(Optional.empty());
  private volatile Optional<RoboframeTopics> topics = Optional.empty();

  void tell(RoboframeTopics reader) {
    topics = Optional.of(reader);
  }

  /** The keys, where others were said since this was asked last. */
  Optional<List<BoardKey>> take() {
    return keys.getAndSet(Optional.empty());
  }

  @Override
  public void board(BrokerLink link, List<BoardKey> said) {
    keys.set(Optional.of(said));
  }

  @Override
  public void value(BrokerLink link, BrokerMessage.Value value) {
    topics.ifPresent(reader -> reader.received(value));
  }

  @Override
  public void ended(BrokerLink link, String reason) {
    // the session asks the link
  }
}
