"""How comments of exercises ask for what is left to be written, in the languages that courses are held in."""

from __future__ import annotations

import re

from ...lazy_regex import regex

TO_DO = regex(
    r"(?i)\bto[ -]?dos?\b|\bfix-?me\b|\bexer(?:cise|cice|c[ií]cio)s?\b|\bejercicios?\b|\besercizi[o]?\b"
    r"|\b(?:aufgaben?|übung(?:en)?|homework|pendiente|упражнение|задание|complet(?:ar|are)|compl[ée]ter)\b|課題|演習|宿題|练习|待办|待辦|과제|실습"
)
MAKING = regex(
    r"(?i)\b(?:creat|add|defin|implement|writ|complet|initiali[sz]|instantiat|fill|declar|insert|import|finish"
    r"|export|upload|migrat|port(?=(?:ed|ing)?\b)"
    r"|erstell|schreib|erg[äa]nz|hinzuf[üu]g|einf[üu]g|vervollst[äa]nd|füg|füll"
    r"|implément|cré|crea|complét|ajout|écri|ecri|défini|déclar|añad|agreg|escrib|rellen|cria|escrev|preench|adicion"
    r"|aggiung|scriv|riemp|добав|напиш|реализ|созда)\w*"
    r"|追加|実装|作成|記述|書いて|書く|書き|定義|完成|编写|編寫|补充|補充|补全|添加|填[写寫入]|实现|實作|實現|定义|创建"
    r"|작성|구현|추가|완성|채우|정의|만들"
)
OPEN = regex(
    r"(?i)\b(?:your|student'?s?) (?:own )?(?:code|solution|implementation|answer|work)\b|\bcode (?:goes )?here\b"
    r"|\bfill (?:me )?in\b|\bcomplete (?:this|the (?:code|function|method|class))\b"
    r"|\b(?:add|insert|put|write) (?:the |some )?(?:code|implementation) (?:below|here)\b|\bmissing code\b"
    r"|\byour turn\b|\b(?:begin|start|end) (?:of )?(?:your )?solution\b|\bescrib\w* aqu[ií]\b|\bà vous de jouer\b"
    r"|\b(?:dein|ihr|euer|eur)en? (?:eigene[nr]? )?code\b|\bcode (?:hier|ici)\b|\bhier (?:den |deinen |ihren )?code\b"
    r"|\b(?:tu|su|vuestro|seu|teu) c[oó]digo\b|\bc[oó]digo aqu[ií]\b|\b(?:votre|ton) code\b|\bà compléter\b"
    r"|\b(?:tuo|vostro) codice\b|\bcodice qui\b|\bda completare\b|\bваш код\b|\bкод здесь\b"
    r"|(?:ここ|以下|下)に.{0,10}(?:コード|プログラム|処理)"
    r"|(?:コード|プログラム|処理)を.{0,8}(?:ください|下さい|しよう|せよ|なさい)"
    r"|你的?(?:代码|程式碼|程式)|(?:代码|程式碼)(?:写|填|放|加)?在?(?:这里|此处|這裡|此處)"
    r"|(?:此处|这里|這裡|此處|下面|下方|以下).{0,8}(?:编写|編寫|添加|填写|填寫|补充|補充|实现|写|寫).{0,8}(?:代码|程式碼|程式)"
    r"|(?:补全|补充|补完)(?:代码|程序|函数)|여기에.{0,12}(?:코드|작성|구현)|코드를.{0,12}(?:세요|시오)"
)
WORDY = regex("[a-z]+")
"""A name that may also be a plain word: `main`, `listener`."""
PART = regex("[A-Z]?[a-z0-9]+|[A-Z]+(?![a-z])")
"""What a name consists of that may be written as several words: `timer_callback`, `MyTalker`."""
OF_CODE = (
    r"(?:function|method|class|module|node|file|def|función|clase|función|fonction|classe|funktion|klasse|funzione"
    r"|função|функци\w+|класс)"
)


def says_name(said: str, name: str) -> bool:
    """Return whether a comment has a name, one that is a plain word only as one of code: `main()`, a class `main`."""
    own = re.escape(name)
    if re.search(rf"[`'\"]{own}[`'\"(]|(?<![\w.]){own}(?:\(|\.(?:py|cpp|msg|srv|action)\b)|\bself\.{own}\b", said):
        return True
    if WORDY.fullmatch(name):
        return re.search(rf"(?i)\b{OF_CODE} {own}\b|\b{own}[ -]?(?:{OF_CODE}|関数|函数|函式|함수)", said) is not None
    if re.search(rf"(?<![\w]){own}(?!\w)", said):
        return True
    words = PART.findall(name)
    return len(words) > 1 and re.search(rf"(?i)(?<![^\W_]){'[ _-]?'.join(words)}(?![^\W_])", said) is not None
