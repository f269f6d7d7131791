package org.robotui.gazebo.internal;

import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;

/** What discovery finds, on its thread, one call at a time. */
interface DiscoveryEvents {

  /** A node has something; said again about once a second. */
  void found(Announcement announced);

  /** A node has it no more. */
  void lost(Announcement announced);

  /** A node of another process receives what we publish. */
  void connected(Announcement subscription);

  /** It does so no longer, or its process has gone. */
  void disconnected(Announcement subscription);

  /** A process was heard for the first time, or is not heard any more. */
  void processes();

  /** Somebody wants to know to what we subscribe. */
  void subscribersWanted();

  /** Something came that nobody can read. */
  void unreadable(String reason);
}
