package org.robotui.install;

/** What has become of a wish to install, update or remove. */
public sealed interface InstallOutcome {
  /**
   * What is to be said to the user.
   *
   * @return one or more sentences
   */
  String sentence();

  /**
   * The product is another one now.
   *
   * @param sentence what has come and gone
   * @param restart true where it takes effect with the next start, since the application itself uses what was replaced
   */
  record Changed(String sentence, boolean restart) implements InstallOutcome {}

  /**
   * There was nothing to do.
   *
   * @param sentence why
   */
  record Unchanged(String sentence) implements InstallOutcome {}

  /**
   * It was not done, and the product is as it was.
   *
   * @param reason for programs
   * @param sentence for users
   */
  record Refused(Reason reason, String sentence) implements InstallOutcome {}

  /** Why something was not done. */
  enum Reason {
    /** Something that is needed is not there, or something that is there does not go with it. */
    CONFLICT,
    /** The site cannot be read. */
    UNREACHABLE,
    /** Neither the site nor the product has such a feature. */
    UNKNOWN_FEATURE,
    /** It is not signed, and the user did not want it so. */
    UNSIGNED,
    /** What was received is not what the site announces. */
    DAMAGED,
    /** Anything else, such as a disk that is full or a folder that cannot be written. */
    FAILED
  }
}
