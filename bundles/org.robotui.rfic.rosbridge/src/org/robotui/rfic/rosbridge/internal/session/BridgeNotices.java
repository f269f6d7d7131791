package org.robotui.rfic.rosbridge.internal.session;

import org.robotui.data.status.Severity;
import org.robotui.message.topic.ServerNotices;
import org.robotui.rosbridge.BridgeListener;

/**
 * Takes down what a bridge says of what it was told.
 *
 * @param notices where
 */
record BridgeNotices(ServerNotices notices) implements BridgeListener {

  @Override
  public void onUnreadable(String reason) {
    notices.unreadable(reason);
  }

  @Override
  public void onStatus(String level, String message) {
    notices.said(switch (level) {
      case "error" -> Severity.ERROR;
      case "warning" -> Severity.WARNING;
      default -> Severity.INFO;
    }, message);
  }
}
