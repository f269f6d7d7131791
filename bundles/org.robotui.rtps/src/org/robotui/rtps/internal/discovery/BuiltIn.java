package org.robotui.rtps.internal.discovery;

import org.robotui.rtps.EntityId;

/** The endpoints that participants have for each other, and the bits by which they say so. */
public final class BuiltIn {

  public static final EntityId PARTICIPANT_WRITER = new EntityId(0x000100c2);
  public static final EntityId PARTICIPANT_READER = new EntityId(0x000100c7);
  public static final EntityId PUBLICATIONS_WRITER = new EntityId(0x000003c2);
  public static final EntityId PUBLICATIONS_READER = new EntityId(0x000003c7);
  public static final EntityId SUBSCRIPTIONS_WRITER = new EntityId(0x000004c2);
  public static final EntityId SUBSCRIPTIONS_READER = new EntityId(0x000004c7);
  public static final EntityId MESSAGE_WRITER = new EntityId(0x000200c2);
  public static final EntityId MESSAGE_READER = new EntityId(0x000200c7);

  public static final int HAS_PARTICIPANT_WRITER = 1;
  public static final int HAS_PARTICIPANT_READER = 1 << 1;
  public static final int HAS_PUBLICATIONS_WRITER = 1 << 2;
  public static final int HAS_PUBLICATIONS_READER = 1 << 3;
  public static final int HAS_SUBSCRIPTIONS_WRITER = 1 << 4;
  public static final int HAS_SUBSCRIPTIONS_READER = 1 << 5;
  public static final int HAS_MESSAGE_WRITER = 1 << 10;
  public static final int HAS_MESSAGE_READER = 1 << 11;

  /** What this library has: finding participants and endpoints, and telling that they are alive. */
  public static final int OURS = HAS_PARTICIPANT_WRITER | HAS_PARTICIPANT_READER | HAS_PUBLICATIONS_WRITER
      | HAS_PUBLICATIONS_READER | HAS_SUBSCRIPTIONS_WRITER | HAS_SUBSCRIPTIONS_READER | HAS_MESSAGE_WRITER
      | HAS_MESSAGE_READER;

  private BuiltIn() {}
}
