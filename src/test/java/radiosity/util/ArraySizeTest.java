package radiosity.util;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class ArraySizeTest {

    @Test
    void productsThatFit_areThemselves() {
        assertEquals(6, ArraySize.of("points", 1, 2, 3));
        assertEquals(0, ArraySize.of("points", 0, Long.MAX_VALUE));
        assertEquals(ArraySize.MOST, ArraySize.of("points", ArraySize.MOST));
    }

    /** The first two are negative as ints, the third a small positive number. */
    @Test
    void productsBeyondAnArray_areRefusedWithTheirNumber() {
        assertRefused("2,304,000,000", 3, 768, 1_000_000);
        assertRefused("2,147,483,648", 1L << 31);
        assertRefused("4,294,967,300", 4, 1_073_741_825);
    }

    private static void assertRefused(String number, long... factors) {
        assertEquals("light: expected at most 2,147,483,639 numbers, got " + number,
                assertThrows(TooLargeException.class, () -> ArraySize.of("light", factors)).getMessage());
    }

    /** An array that is doubled goes beyond what an array can be long before what it must hold does. */
    @Test
    void room_isWhatIsWantedOrWhatAnArrayHolds() {
        assertEquals(2000, ArraySize.room("light", 1001, 2000, 768));
        assertEquals(1001, ArraySize.room("light", 1001, 900, 768));
        assertEquals(2_796_202, ArraySize.room("light", 1_500_001, 3_000_000, 768));
        assertThrows(TooLargeException.class, () -> ArraySize.room("light", 2_796_203, 5_000_000, 768));
    }
}
