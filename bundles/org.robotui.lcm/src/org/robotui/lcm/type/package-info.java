/**
 * The types of LCM messages: the type language of {@code .lcm} files ({@link org.robotui.lcm.type.TypeParser}), all
 * types that are known ({@link org.robotui.lcm.type.TypeLibrary}), and messages of any type as records
 * ({@link org.robotui.lcm.type.LcmRecord}) whose arrays of numbers stay in the bytes that came.
 *
 * <p>Bytes come from peers and are not trusted: every size is checked against the bytes that are there before anything
 * is made for it, and errors name the type and the member.
 *
 * <p>Source: "LCM Type Specification Language" in LCM's documentation.
 */
package org.robotui.lcm.type;
