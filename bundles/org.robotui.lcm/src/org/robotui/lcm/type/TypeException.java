package org.robotui.lcm.type;

/** A {@code .lcm} file that cannot be used: says where, what is wrong, and what to write. */
public final class TypeException extends Exception {

  private static final long serialVersionUID = 1L;

  private final transient Place place;

  /**
   * Creates the error.
   *
   * @param place where it is
   * @param problem what is wrong
   * @param remedy what to write or do
   */
  public TypeException(Place place, String problem, String remedy) {
    super(place + ": " + problem + "; " + remedy);
    this.place = place;
  }

  /**
   * Where it is.
   *
   * @return file, line and column
   */
  public Place place() {
    return place;
  }
}
