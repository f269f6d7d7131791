package org.robotui.rtps;

/** Whether lost samples are sent again. What is later in this list offers more. */
public enum Reliability {
  /** What is lost is lost. */
  BEST_EFFORT,
  /** What is lost is sent again, as long as the writer still has it. */
  RELIABLE
}
