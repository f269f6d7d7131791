package org.robotui.rtps.internal.discovery;

/** How long what peers say of themselves may be. */
final class FieldBounds {

  /** Names of topics and types, in bytes; DDS and ROS 2 stay below 256. */
  static final int NAME = 1024;

  /** User data, in bytes. */
  static final int USER_DATA = 16 << 10;

  /** Locators of a kind. */
  static final int LOCATORS = 16;

  /** Partitions, and bytes of each. */
  static final int PARTITIONS = 256;

  static final int REPRESENTATIONS = 16;

  private FieldBounds() {}
}
