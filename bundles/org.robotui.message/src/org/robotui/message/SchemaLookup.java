package org.robotui.message;

/**
 * The answer to the question for a type.
 *
 * @param <S> {@link MessageSchema} or {@link ServiceSchema}
 */
public sealed interface SchemaLookup<S> {

  /**
   * The type is known.
   *
   * @param schema the type
   * @param <S> its kind
   */
  record Found<S>(S schema) implements SchemaLookup<S> {}

  /**
   * The type is not known, or not as asked.
   *
   * @param reason why, for a user to read
   * @param <S> its kind
   */
  record Missing<S>(String reason) implements SchemaLookup<S> {}
}
