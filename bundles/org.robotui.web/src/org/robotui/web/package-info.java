/**
 * What libraries of protocols over WebSockets share: links with bounded messages, in which a command goes out before
 * all that waits ({@code WebLink}), and what has arrived, of which only the newest is kept where only the newest counts
 * ({@code Arrivals}).
 */
package org.robotui.web;
