package org.robotui.entity.marker.internal;

import org.robotui.data.marker.MarkerFeedback;

/** Takes what a user did to the robot. */
@FunctionalInterface
interface Sender {
  /** Sends, and tells whether the robot was asked at all. */
  boolean send(MarkerFeedback feedback);
}
