package org.robotui.smartsoft.internal;

import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.net.link.FrameLink;
import org.robotui.smartsoft.wire.SmartFrame;

/** A client as a server sees it. */
public final class ServedClient {

  private final FrameLink<SmartFrame> link;
  private final AtomicBoolean taken = new AtomicBoolean();

  ServedClient(FrameLink<SmartFrame> link) {
    this.link = link;
  }

  FrameLink<SmartFrame> link() {
    return link;
  }

  void take() {
    taken.set(true);
  }

  boolean isTaken() {
    return taken.get();
  }

  /** Says something in its turn; false where it is gone, or takes too little. */
  public boolean send(SmartFrame frame) {
    return link.send(frame);
  }

  /** Says something in place of what it has not taken yet. */
  public boolean replace(String kind, SmartFrame frame) {
    return link.replace(kind, frame);
  }
}
