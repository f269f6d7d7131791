package org.robotui.uic.jointcontrol.internal.model;

/** A line of the table. */
public sealed interface JointLine permits ChainHead, JointRow {
  /** What identifies it, so that it stays selected while others come and go. */
  String key();
}
