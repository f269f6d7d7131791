package org.robotui.web.tree;

/** What JSON calls null. */
public enum JsonNull {
  /** The only value. */
  NULL
}
