/**
 * Who is in the domain: what participants and endpoints say of themselves as records and as parameter lists, who of
 * them is known and for how long, and by which ports they are found.
 *
 * <p>Nothing here sends or receives, and time is given: built-in endpoints drive it.
 */
package org.robotui.rtps.internal.discovery;
